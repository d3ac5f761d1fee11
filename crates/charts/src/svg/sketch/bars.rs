//! Elements between two points, as paths along their first axis.

/// A spring with the length of a path before stretching.
pub(super) const SPRING: &str = "M0 0H12l4-8 8 16 8-16 8 16 8-16 8 16 8-16 8 16 8-16 8 16 4-8H100";

/// A dashpot: a piston in a cylinder.
pub(super) const DASHPOT: &str = "M0 0H45M45-5V5M36-8H65V8H36M65 0H100";

/// A dashpot parallel to a spring between the same ends.
pub(super) const DASHPOT_BESIDE: &str = "M6 0V18H45M45 13V23M36 10H65V26H36M65 18H94V0";

/// A force between two points: arrows away from each other.
pub(super) const ACTUATOR: &str = "M0 0H100M12-6L0 0 12 6M88-6L100 0 88 6";
