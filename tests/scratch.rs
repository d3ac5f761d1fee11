#[test]
fn times() {
    let t = std::time::Instant::now();
    let page = derivations::principles::page();
    eprintln!("made {:?}", t.elapsed());
    for claim in page.claims() {
        let t = std::time::Instant::now();
        let j = claim.judge(derivations::principles::dimension);
        eprintln!(
            "{:<30} {:?} {:?} {} {:?} {:?}",
            claim.id,
            t.elapsed(),
            j.verdict,
            j.evidence.chars().take(150).collect::<String>(),
            j.objections.first().map(|o| o.chars().take(300).collect::<String>()),
            j.difference.as_ref().map(|d| d.0.clone())
        );
        if let Err(e) = j.sound() {
            eprintln!("UNSOUND {e}");
        }
    }
    eprintln!("all {:?}", t.elapsed());
}
