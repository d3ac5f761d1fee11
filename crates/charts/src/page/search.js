// Search over the whole page: claims, findings, scenes, pictures, studies. Without this script the contents are read.
"use strict";
{
  const NAMED = ["section", "article", "h3"].map((name) => `main ${name}[id]`).join();
  const MOST = 50;
  const box = document.querySelector(".search");
  const [input, output, list] = ["input", "output", "ol"].map((name) => box.querySelector(name));
  const title = (place) => place.querySelector("h2, h3, h4") ?? place;

  // What is in no named place within it is a place's own; read when it is first asked for.
  let places;
  const read = () => {
    const texts = new Map([...document.querySelectorAll(NAMED)].map((place) => [place, []]));
    const walker = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const { data, parentElement } = walker.currentNode;
      // formulas are found as they are read, without spaces
      texts.get(parentElement.closest(NAMED))?.push(parentElement.closest("math") ? data : ` ${data} `);
    }
    places = [...texts].map(([place, parts]) => {
      const text = parts.join("").replace(/\s+/g, " ");
      return { id: place.id, name: title(place).textContent.trim(), text, low: `${text} ${place.id}`.toLowerCase() };
    });
  };

  const hit = ({ id, name, text, low }, word) => {
    const item = document.createElement("li");
    const link = item.appendChild(document.createElement("a"));
    link.href = `#${encodeURI(id)}`;
    link.textContent = name;
    const at = name.toLowerCase().includes(word) ? -1 : low.indexOf(word);
    const near = at < 0 || at >= text.length ? id : `… ${text.slice(Math.max(0, at - 30), at + 50)} …`;
    item.append(Object.assign(document.createElement("span"), { className: "count", textContent: near }));
    return item;
  };

  const find = () => {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length && !places) read();
    const found = words.length ? places.filter(({ low }) => words.every((word) => low.includes(word))) : [];
    const named = ({ name }) => words.every((word) => name.toLowerCase().includes(word));
    found.sort((a, b) => named(b) - named(a));
    list.replaceChildren(...found.slice(0, MOST).map((place) => hit(place, words[0])));
    const more = found.length > MOST ? `, the first ${MOST} shown` : "";
    output.value = words.length ? `${found.length} ${found.length === 1 ? "place" : "places"}${more}` : "";
  };

  input.addEventListener("input", find);
  addEventListener("keydown", (event) => {
    if (event.key !== "/" || /^(INPUT|TEXTAREA)$/.test(event.target.tagName)) return;
    event.preventDefault();
    input.focus();
  });
  box.hidden = false;

  // A link to every place, for others to be sent.
  for (const place of document.querySelectorAll("section[id], article.scene, h3[id]")) {
    const here = Object.assign(document.createElement("a"), { className: "here" });
    here.href = `#${encodeURI(place.id)}`;
    here.setAttribute("aria-label", "Link to this place");
    title(place).append(" ", here);
  }
}
