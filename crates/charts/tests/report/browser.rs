//! The page in a browser: it loads without errors, and search, filter and links work.

use dalembert_charts::page;
use std::process::Command;

/// The lines that a script reports when it runs after the scripts of the page; `None` if no browser is installed.
fn told(name: &str, script: &str) -> Option<Vec<String>> {
    const WATCH: &str = "<script>const told = []; addEventListener('error', (e) => told.push(`error: ${e.message}`));\
        addEventListener('securitypolicyviolation', (e) => told.push(`outside: ${e.blockedURI}`))</script>";
    const TELL: &str = "document.body.append(Object.assign(document.createElement('pre'), \
                        { id: 'told', textContent: told.join('\\n') }))";
    let html = page::render(&crate::report::specimen()).html.replacen("<style>", &format!("{WATCH}<style>"), 1);
    let html = html.replace("</body>", &format!("<script>{script};{TELL}</script></body>"));
    let file = std::env::temp_dir().join(format!("dalembert_{}_{name}.html", std::process::id()));
    std::fs::write(&file, html).expect("it can be written");
    let arguments = ["--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", "--dump-dom"];
    let browser = ["chromium", "chromium-browser", "google-chrome"].into_iter().find_map(|browser| {
        Command::new(browser).args(arguments).arg(format!("file://{}", file.display())).output().ok()
    });
    std::fs::remove_file(&file).expect("it was written");
    let Some(browser) = browser else {
        eprintln!("skipped: there is no Chromium on this machine");
        return None;
    };
    let complaints = String::from_utf8_lossy(&browser.stderr);
    assert!(!complaints.contains("CONSOLE"), "{complaints}");
    let page = String::from_utf8_lossy(&browser.stdout);
    let (_, rest) = page.rsplit_once("<pre id=\"told\">").expect("the script came to its end");
    let text = rest.split_once("</pre>").expect("it was closed").0;
    Some(text.lines().map(str::to_owned).collect())
}

#[test]
fn words_are_found_in_claims_scenes_and_studies() {
    const FIND: &str = "const box = document.querySelector('.search'), input = box.querySelector('input');
        const find = (words) => {
          input.value = words;
          input.dispatchEvent(new Event('input'));
          return [...box.querySelectorAll('li a')];
        };
        for (const words of ['balance FORM first', 'ω0(−ν)', 'stiff windings falls', 'no such words']) {
          const hits = find(words);
          const there = hits.every((hit) => document.getElementById(decodeURIComponent(hit.hash.slice(1))));
          told.push(`${words}: ${hits.length} of ${box.querySelector('output').value}, there: ${there}`);
        }
        const hits = find('e').length;
        told.push(`${hits} shown; ${box.querySelector('output').value}`);
        told.push(`${find('').length} without a word`)";
    let Some(told) = told("search", FIND) else { return };
    let [form, letter, failure, nothing, many, none] = &told[..] else { panic!("{told:?}") };
    let found = |line: &str| line.split(": ").nth(1).and_then(|rest| rest.split(' ').next()?.parse().ok()).unwrap_or(0);
    for line in [form, letter, failure] {
        assert!(found(line) >= 1 && line.ends_with("there: true"), "{line}");
    }
    assert_eq!(nothing, "no such words: 0 of 0 places, there: true");
    assert!(many.starts_with("50 shown; ") && many.ends_with(", the first 50 shown"), "{many}");
    assert_eq!(none, "0 without a word");
}

#[test]
fn a_filter_leaves_what_it_says_and_a_link_to_a_hidden_claim_shows_it() {
    const FILTER: &str = "const ledger = document.querySelector('.ledger');
        const shown = () => ledger.querySelectorAll('.claim:not([hidden])').length;
        const all = shown();
        const refuted = ledger.querySelector('button[data-verdict=refuted]');
        refuted.click();
        const left = [...ledger.querySelectorAll('.claim:not([hidden])')];
        told.push(`${left.length < all} ${left.every((claim) => claim.classList.contains('refuted'))}`);
        const hidden = ledger.querySelector('.claim[hidden]');
        location.hash = hidden.querySelector('a.id').hash;
        dispatchEvent(new HashChangeEvent('hashchange'));
        told.push(`${hidden.hidden} ${shown() === all}`)";
    let Some(told) = told("filter", FILTER) else { return };
    assert_eq!(told, ["true true", "false true"]);
}

#[test]
fn every_place_has_a_link_of_its_own() {
    const LINKS: &str =
        "for (const place of document.querySelectorAll('main section[id], main article[id], main h3[id]')) {
          const links = [...place.querySelectorAll('a.here, a.id')].map((a) => decodeURIComponent(a.hash.slice(1)));
          const own = place.id.replace('finding/', '');
          if (!links.includes(own)) told.push(`without a link: ${place.id}`);
        }
        told.push('done')";
    let Some(told) = told("links", LINKS) else { return };
    assert_eq!(told, ["done"]);
}
