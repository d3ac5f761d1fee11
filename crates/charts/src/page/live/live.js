// Parts of the page as the program tells them, and the values of sliders told to the program.
"use strict";
const live = document.querySelector(".live");
const lost = document.getElementById("connection");
const source = new EventSource(`events?since=${live.dataset.version}`);

// At most one change is under way, so that a slider that moves on does not stop every run before its end.
const PATIENCE = 400;
let moved = {}, waiting = false, timer = 0, dragged = null;

const sliders = () => [...document.querySelectorAll("#values input")];
const shown = (number) => String(Number(Number(number).toPrecision(4)));

const entitle = () => (document.title = document.querySelector("#heading h1")?.textContent ?? document.title);
entitle();

const settle = (values) => {
  for (const slider of sliders()) {
    const value = values[slider.name] ?? slider.dataset.own;
    if (slider !== dragged) slider.value = value;
    slider.parentElement.querySelector("output").value = slider === dragged ? shown(slider.value) : value;
  }
  const reset = document.querySelector("#values .reset");
  if (reset) reset.disabled = Object.keys(values).length === 0;
};

const place = ({ part, state, content, fault }) => {
  const section = document.getElementById(part);
  section.dataset.state = state;
  if (content !== undefined) section.querySelector(".content").innerHTML = content;
  if (fault !== undefined) section.querySelector(".fault").innerHTML = fault;
  if (part === "heading") entitle();
  if (part === "values" && content !== undefined) [moved, dragged] = [{}, null];
  // an earlier text is not run
  if (part === "values") section.querySelector("fieldset").disabled = state !== "current";
  if (part === "motion" && state !== "working") release();
};

const send = () => {
  if (waiting) return;
  waiting = true;
  const now = moved;
  timer = setTimeout(release, PATIENCE);
  fetch("values", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(now) })
    .catch(() => (lost.hidden = false));
  sent = now;
};
let sent = moved;
const release = () => {
  clearTimeout(timer);
  waiting = false;
  if (sent !== moved) send();
};

source.addEventListener("message", ({ data }) => {
  const told = JSON.parse(data);
  told.parts.forEach(place);
  if (!told.values) return;
  settle(told.values);
  // sliders that another page moved, unless one is being moved here
  if (!waiting && dragged === null)
    sent = moved = Object.fromEntries(Object.entries(told.values).map(([name, value]) => [name, Number(value)]));
});
source.addEventListener("open", () => (lost.hidden = true));
source.addEventListener("error", () => (lost.hidden = false));
source.addEventListener("end", () => {
  source.close();
  lost.hidden = false;
});

const values = document.getElementById("values");
values.addEventListener("input", ({ target }) => {
  dragged = target;
  target.parentElement.querySelector("output").value = shown(target.value);
  moved = { ...moved, [target.name]: Number(target.value) };
  send();
});
values.addEventListener("change", () => (dragged = null));
values.addEventListener("click", ({ target }) => {
  if (!target.matches(".reset")) return;
  [moved, dragged] = [{}, null];
  settle(moved);
  waiting = false;
  send();
});
