// Filters of the ledgers: by verdict and by text. Without this script every claim is shown.
"use strict";
for (const ledger of document.querySelectorAll(".ledger")) {
  const bar = ledger.querySelector(".filter");
  const buttons = [...bar.querySelectorAll("button")];
  const input = bar.querySelector("input");
  const output = bar.querySelector("output");
  const groups = [...ledger.querySelectorAll(".group")];
  const claims = [...ledger.querySelectorAll(".claim")];
  const texts = new Map(claims.map((claim) => [claim, claim.textContent.toLowerCase()]));

  const apply = () => {
    const chosen = new Set(buttons.filter((b) => b.ariaPressed === "true").map((b) => b.dataset.verdict));
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const claim of claims) {
      const visible =
        (chosen.size === 0 || chosen.has(claim.classList[1])) &&
        words.every((word) => texts.get(claim).includes(word));
      claim.hidden = !visible;
      shown += visible;
    }
    for (const group of groups) group.hidden = !group.querySelector(".claim:not([hidden])");
    output.value = shown < claims.length ? `${shown} of ${claims.length}` : "";
  };

  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.hidden && ledger.contains(target)) {
      for (const button of buttons) button.ariaPressed = "false";
      input.value = "";
      apply();
      target.scrollIntoView();
    }
  };

  for (const button of buttons) {
    button.addEventListener("click", () => {
      button.ariaPressed = String(button.ariaPressed !== "true");
      apply();
    });
  }
  input.addEventListener("input", apply);
  addEventListener("hashchange", reveal);
  bar.hidden = false;
}

// What is folded on the screen is open on paper.
const unfolded = [];
addEventListener("beforeprint", () => {
  for (const folded of document.querySelectorAll("details:not([open])")) {
    folded.open = true;
    unfolded.push(folded);
  }
});
addEventListener("afterprint", () => {
  while (unfolded.length) unfolded.pop().open = false;
});
