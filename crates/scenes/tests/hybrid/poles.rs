//! Events at singular positions of the coordinates, where the law is undefined.

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene};

/// A ball rolls on a plane with a constant angular velocity; its Euler angle theta passes through zero at 0.45 s.
fn ball() -> String {
    "title = \"ball\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[parameters]\nm = \"2 kg\"\nr = \"0.4 m\"\n\
     [coordinates]\nx = \"m\"\ny = \"m\"\npsi = \"rad\"\ntheta = \"rad\"\nphi = \"rad\"\n\
     [frames]\nB = \"N turned psi about z\"\nC = \"B turned theta about x\"\nD = \"C turned phi about z\"\n\
     [points]\nG = \"O + x*N.x + y*N.y + r*N.z\"\nP = \"G - r*N.z\"\n\
     [bodies.ball]\nframe = \"D\"\ncentre = \"G\"\nmass = \"m\"\n\
     inertia = { principal = [\"0.4*m*r^2\", \"0.4*m*r^2\", \"0.4*m*r^2\"] }\n\
     [[constraint]]\nname = \"rolling\"\nzero = [\"velocity(ball at P) . N.x\", \"velocity(ball at P) . N.y\"]\n\
     [[event]]\nname = \"pole\"\nwhen = \"theta\"\ndirection = \"down\"\nend = true\n\
     [start]\ntheta = \"1.0307591655675612 rad\"\npsi = \"3.092327948275996 rad\"\n\
     \"theta'\" = \"-1.8336527435746053 rad/s\"\n\"psi'\" = \"1.9812862693302207 rad/s\"\n\
     \"phi'\" = \"1.9812862693302205 rad/s\"\n[run]\nspan = \"1 s\"\n"
        .to_owned()
}

/// A method that steps over the pole continues on another motion. It must find the event, or stop before it, and report no other time.
#[test]
fn an_event_at_a_pole_is_where_its_expression_is_zero() {
    let scene = ModelScene::parse("ball.toml", &ball()).unwrap_or_else(|error| panic!("{error}"));
    for method in [Method::Rodas4, Method::Radau5, Method::DormandPrince8, Method::Taylor] {
        for tolerance in [1e-6, 1e-7, 1e-8] {
            let choice = Choice { method, tolerance, ..scene.run().choice() };
            let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
            let theta = trajectory.last[trajectory.column("theta").expect("a column")];
            match trajectory.stopped() {
                None => assert!(theta.abs() < 1e-10, "{method:?} {tolerance}: {theta}"),
                Some(_) => assert!(trajectory.outcome.time <= 0.45 + 1e-6 && theta > -1e-6, "{method:?} {tolerance}"),
            }
        }
    }
}
