//! `dalembert stationary --map A=FROM..TO --map B=FROM..TO`: an exact stability map of the rotation about the rotor's axis. Where the bodies have
//! no such common axis, or with --every: a map of all steady motions, continued from node to node.

use super::{Args, Ranged};
use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::output::{Form, Output, Writes};
use crate::{region_map, stability_map};
use serde_json::{Value, json};
use std::fmt::Write;
use studies::scene::Scene;
use studies::stationary::stability::datum::{Datum, Unknown};
use studies::stationary::stability::plane::{Cell, NoPlane};
use studies::stationary::stability::region::NoRegion;

/// Prints the map, and writes the requested picture.
pub(super) fn show(asked: &Args, scene: &Scene) -> Result<Exit, Exit> {
    let refused = |reason: NoPlane| Exit::refused(format!("{}: {reason}", asked.scene.display()));
    let unknown = |reason: Unknown| Exit::refused(format!("{}: {reason}", asked.scene.display()));
    let [first, second] = &asked.map[..] else {
        return Err(Exit::refused("a map has two data; --map A=FROM..TO --map B=FROM..TO is accepted"));
    };
    let datum = |ranged: &Ranged| Datum::named(scene, &ranged.name).map_err(unknown);
    let data = [datum(first)?, datum(second)?];
    if asked.omega0.is_some() && data.iter().any(|datum| datum.name == "omega0") {
        return Err(Exit::refused(
            "--omega0 does not apply to a map over omega0, which says all of its values; leave it out, or map two other data",
        ));
    }
    let writes = Writes { command: "stationary", force: asked.force, reads: vec![&asked.scene] };
    let output = writes.optional(asked.out.as_deref(), &[Form::Picture])?;
    let map = stability_map::MapRequest {
        scene,
        data: [(&data[0], first.range), (&data[1], second.range)],
        speed: asked.omega0.unwrap_or(0.0),
        hanging: !asked.upright,
    };
    let columns = if asked.every { None } else { Some(map.columns()) };
    let columns = match columns {
        Some(Err(NoPlane::Oblique { .. } | NoPlane::Bent { .. })) if !asked.upright => None,
        Some(columns) => Some(columns.map_err(refused)?),
        None => None,
    };
    let Some(columns) = columns else {
        let data = map.data;
        return every(asked, output, &region_map::MapRequest { scene, data, speed: map.speed });
    };
    print(&match asked.format {
        Format::Text => text(scene, &data, &columns),
        Format::Json => format!("{:#}\n", object(scene, &data, &columns)),
    })?;
    if let Some(output) = output {
        output.write_text(&map.map(&columns).svg())?.tell(asked.format)?;
    }
    Ok(Exit::Done)
}

/// Prints and draws the map of all steady motions.
fn every(asked: &Args, output: Option<Output>, map: &region_map::MapRequest<'_>) -> Result<Exit, Exit> {
    let refused = |reason: NoRegion| Exit::refused(format!("{}: {reason}", asked.scene.display()));
    let atlas = map.atlas().map_err(refused)?;
    print(&match asked.format {
        Format::Text => map.text(&atlas),
        Format::Json => format!("{:#}\n", map.object(&atlas)),
    })?;
    if let Some(output) = output {
        output.write_text(&map.sheet(&atlas))?.tell(asked.format)?;
    }
    Ok(Exit::Done)
}

fn text(scene: &Scene, [first, second]: &[Datum; 2], columns: &[(f64, Cell)]) -> String {
    let mut out = format!("{}\n", scene.title);
    for (value, cell) in columns {
        // writing to a String cannot fail
        let _ = write!(out, "{} = {value}: ", first.name);
        let _ = match cell {
            Cell::PulledOut => writeln!(out, "the motor is pulled out"),
            Cell::Decided(column) => {
                let mut line = column.fates.first().map_or("", |fate| fate.name()).to_owned();
                for (edge, fate) in column.edges.iter().zip(column.fates.iter().skip(1)) {
                    let _ = write!(line, "; from {} = {} {}", second.name, edge.at, fate.name());
                }
                writeln!(out, "{line}")
            }
        };
    }
    out
}

fn object(scene: &Scene, [first, second]: &[Datum; 2], columns: &[(f64, Cell)]) -> Value {
    let each = columns.iter().map(|(value, cell)| match cell {
        Cell::Decided(column) => json!({
            "value": value,
            "edges": column.edges.iter().map(|edge| json!({ "at": edge.at, "neutral": edge.neutral })).collect::<Vec<_>>(),
            "verdicts": column.fates.iter().map(|fate| fate.name()).collect::<Vec<_>>(),
        }),
        Cell::PulledOut => json!({ "value": value, "pulled_out": true }),
    });
    json!({ "scene": scene.title, "model": scene.machine.name(), "first": first.name, "second": second.name,
            "columns": each.collect::<Vec<_>>() })
}
