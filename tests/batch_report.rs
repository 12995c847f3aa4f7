//! The report of a batch in a real browser: what it shows, and that it can be sorted and filtered.
#![cfg(unix)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod batch_support;
mod cli_support;

use batch_support::PLAN;
use cli_support::{Workshop, text};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

/// Runs the browser without a window.
fn browse(folder: &Path, arguments: &[&str]) -> String {
    let program = ["chromium", "chromium-browser", "google-chrome"];
    let found = program.iter().find(|p| Command::new(p).arg("--version").output().is_ok());
    let program =
        found.expect("this test opens the report in Chromium: install `chromium`, or run `scripts/test`");
    let mut browser = Command::new(program);
    // A browser of its own, without the sandbox that root cannot have; there is nothing to guard from this page.
    browser.args(["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]);
    browser.arg(format!("--user-data-dir={}", folder.join("browser").display())).args(arguments);
    let output = browser.current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// What the page shows: names in the first column, states, how many of how many, and which column it is sorted by.
const LOOK: &str = r##"
const look = () => ({
  names: [...document.querySelectorAll("#body .file")].slice(0, 20).map(e => e.textContent),
  states: [...new Set([...document.querySelectorAll("#body td:nth-child(2)")].map(e => e.textContent))],
  shown: document.getElementById("shown").textContent,
  sorted: [...document.querySelectorAll("th[aria-sort]")].map(e => e.textContent + " " + e.getAttribute("aria-sort")).join(),
  pictures: [...document.querySelectorAll("#body img")].filter(i => i.complete && i.naturalWidth > 20).length,
});
const heading = name => [...document.querySelectorAll("th button")].find(b => b.textContent === name).click();
const filter = words => {
  const field = document.getElementById("filter");
  field.value = words;
  field.dispatchEvent(new Event("input", { bubbles: true }));
};
const state = name => [...document.querySelectorAll("#states button")].find(b => b.dataset.state === name).click();
"##;

/// What these steps tell that are done in the page once it is there.
fn told(w: &Workshop, page: &str, steps: &str) -> Value {
    let script = format!(
        "<script>addEventListener('load', () => setTimeout(() => {{
            {LOOK}
            const told = []; {steps}
            const out = document.createElement('pre'); out.id = 'told'; out.textContent = JSON.stringify(told);
            document.body.replaceChildren(out);
        }}, 200));</script></body>"
    );
    w.write("steps.html", page.replace("</body>", &script));
    let dom = browse(&w.path(""), &["--virtual-time-budget=20000", "--dump-dom", "steps.html"]);
    let out = dom.split_once("<pre id=\"told\">").and_then(|(_, rest)| rest.split_once("</pre>"));
    let (out, _) = out.unwrap_or_else(|| {
        panic!("the page's script did not come to its end: {}", &dom[..dom.len().min(3000)])
    });
    let out = out.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    serde_json::from_str(&out).unwrap()
}

fn report() -> (Workshop, String) {
    let w = Workshop::empty();
    w.put_documents(3);
    w.put("in/one room.svg", PLAN.replace(" M600 100V340 M600 440V700", ""));
    w.put("in/<img src=x onerror=alert(1)>.png", "");
    w.run("batch in -o out --to svg --set metres-per-pixel=0.01");
    let page = text(&w.read("out/planform-batch/report.html"));
    (w, page)
}

#[test]
fn the_report_is_sorted_and_filtered_by_clicks() {
    let (w, page) = report();
    let steps = r##"
        told.push(look());
        heading("Rooms"); told.push(look());
        heading("Rooms"); told.push(look());
        state("failed"); told.push(look());
        state("all"); filter("MAPS/0/0 slam-grid"); told.push(look());
        filter("no such words"); told.push(look());
        filter(""); heading("Seconds"); told.push(look());
    "##;
    let told = told(&w, &page, steps);
    let names = |i: usize| -> Vec<&str> {
        told[i]["names"].as_array().unwrap().iter().map(|n| n.as_str().unwrap()).collect()
    };
    assert_eq!(
        (&told[0]["shown"], &told[0]["sorted"]),
        (&json!("15 of 15 shown"), &json!("Document ascending"))
    );
    assert_eq!(names(0)[..3], ["<img src=x onerror=alert(1)>.png", "broken/alone.yaml", "broken/empty.png"]);
    // Five documents and their layouts.
    assert!(told[0]["pictures"].as_u64().unwrap() >= 10, "{}", told[0]["pictures"]);
    assert_eq!(told[2]["sorted"], "Rooms descending");
    assert!(names(2)[0].starts_with("maps/") && names(1).last() == Some(&"plan.svg"), "{told}");
    assert!(
        names(2).iter().position(|n| *n == "one room.svg") > names(2).iter().position(|n| *n == "plan.svg")
    );
    assert_eq!((&told[3]["shown"], &told[3]["states"]), (&json!("5 of 15 shown"), &json!(["failed"])));
    assert_eq!(names(4), ["maps/0/0.yaml"]);
    assert_eq!(told[5]["shown"], "0 of 15 shown");
    assert_eq!(
        (&told[6]["shown"], &told[6]["sorted"]),
        (&json!("15 of 15 shown"), &json!("Seconds ascending"))
    );
}

#[test]
fn ten_thousand_rows_are_no_burden() {
    let (w, page) = report();
    let (before, rest) = page.split_once("id=\"rows\">").unwrap();
    let (rows, after) = rest.split_once("</script>").unwrap();
    let rows: Vec<Value> = serde_json::from_str(rows).unwrap();
    let many = (0..10_000).map(|n| {
        let mut row = rows[n % rows.len()].clone();
        row["name"] = format!("document {n}").into();
        row["seconds"] = json!(f64::from((n * 7919 % 10_000) as u32));
        row.to_string().replace('<', "\\u003c")
    });
    let many = many.collect::<Vec<_>>().join(",\n");
    let page = format!("{before}id=\"rows\">[{many}]</script>{after}");
    let steps = r##"
        const start = performance.now();
        heading("Seconds"); heading("Seconds"); told.push(look());
        filter("document 77"); told.push(look());
        told.push(performance.now() - start);
        told.push(document.querySelectorAll("#body tr").length);
    "##;
    let told = told(&w, &page, steps);
    assert_eq!(
        (&told[0]["shown"], &told[1]["shown"]),
        (&json!("10000 of 10000 shown"), &json!("280 of 10000 shown"))
    );
    assert_eq!(
        told[0]["names"][0],
        format!("document {}", (0..10_000).find(|n| n * 7919 % 10_000 == 9999).unwrap())
    );
    assert!(told[2].as_f64().unwrap() < 5000.0, "{}", told[2]);
    assert!(told[3].as_u64().unwrap() <= 100, "rows are put into the page as they are scrolled to");
}

#[test]
fn the_report_looks_like_one() {
    let (w, _) = report();
    browse(
        &w.path(""),
        &["--window-size=1400,1000", "--screenshot=report.png", "out/planform-batch/report.html"],
    );
    let picture = image::open(w.path("report.png")).unwrap().to_rgb8();
    assert_eq!(picture.dimensions(), (1400, 1000));
    let ink = picture.pixels().filter(|p| p.0.iter().any(|c| *c < 200)).count();
    assert!(ink > 5_000, "{ink} pixels of the page are not pale");
    // A copy to look at.
    std::fs::copy(w.path("report.png"), Path::new(env!("CARGO_TARGET_TMPDIR")).join("batch-report.png"))
        .unwrap();
}
