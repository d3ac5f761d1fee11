//! Elements between two points, as SVG paths along their own first axis, 100 long.

/// A spring; its length in a picture is made by scaling along the first axis.
pub(super) const SPRING: &str = "M0 0H12l4-8 8 16 8-16 8 16 8-16 8 16 8-16 8 16 8-16 8 16 4-8H100";

/// A dashpot: a piston in a cylinder.
pub(super) const DASHPOT: &str = "M0 0H45M45-5V5M36-8H65V8H36M65 0H100";

/// A dashpot parallel to a spring between the same ends.
pub(super) const DASHPOT_BESIDE: &str = "M6 0V18H45M45 13V23M36 10H65V26H36M65 18H94V0";

/// A force between two points: arrows that point away from each other.
pub(super) const ACTUATOR: &str = "M0 0H100M12-6L0 0 12 6M88-6L100 0 88 6";
