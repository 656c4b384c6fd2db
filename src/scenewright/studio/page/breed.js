// Breeding: a sheet of layouts, what is said of them by key and button, and all sheets in one grid.
import { drawCard, element } from "/draw.js";
import { unpack } from "/state.js";
import { t } from "/words.js";
import { $, fill, make, read, say, send } from "/wire.js";

const KEYS = ["1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "-", "="];
const CODES = ["Digit1", "Digit2", "Digit3", "Digit4", "Digit5", "Digit6", "Digit7", "Digit8", "Digit9", "Digit0", "Minus", "Equal"];
let bred = {}, known = new Map(), early = [], all = false, pair = [], leave = null;

export async function showBreeding(back) {
  leave = back;
  for (const id of ["breeding", "taste"]) $(id).hidden = false;
  $("facts").hidden = true; $("breed").ariaPressed = true;
  $("breeding").focus();
  await send("breed");
  await refreshBreeding();
}

export function hideBreeding() {
  for (const id of ["breeding", "taste"]) $(id).hidden = true;
  $("facts").hidden = false; $("breed").ariaPressed = false;
}

export function noteShare(share) { $("breeding-share").value = share; }

let turn = 0;
export async function refreshBreeding() {
  if ($("breeding").hidden) return;
  const mine = ++turn;
  let fresh = await read("/breeding");
  if (fresh.open && !fresh.shown && !fresh.running && document.body.dataset.right === "rate" && mine === turn) {
    await send("breed");
    fresh = await read("/breeding");
  }
  if (mine !== turn) return;
  if (fresh.brief !== bred.brief && fresh.brief) { known = new Map(); pair = []; }
  if (fresh.running && bred.shown && fresh.brief === bred.brief) bred.running = true; else bred = fresh;
  const missing = bred.shown ? [...new Set(bred.sheets.flat())].filter((number) => !known.has(number)) : [];
  if (missing.length && !bred.running) for (const [number, card] of await unpack(await read(`/cards?of=${missing}`))) known.set(number, card);
  if (bred.early && !bred.shown) early = await unpack(bred.early);
  if (mine === turn) show();
}

function show() {
  const running = bred.running;
  $("breeding-share").hidden = $("breeding-stop").hidden = !running;
  $("next").disabled = $("take-back").disabled = running || !bred.shown;
  $("next").textContent = bred.shown || running ? t("Next sheet ⏎") : t("First sheet ⏎");
  if (!bred.shown && !running && bred.open) $("next").disabled = false;
  $("sheets").ariaPressed = all;
  $("sheet-name").textContent = bred.shown ? t("Sheet {n}", { n: bred.sheet + 1 }) : running ? t("Breeding the first layouts …") : t("Breed");
  $("trust").textContent = bred.trust ? t("predictions: {trust}", bred) : "";
  $("cards").classList.toggle("small", all);
  if (!bred.shown) showEarly();
  else if (all) showAll();
  else $("cards").replaceChildren(...bred.shown.map((one, place) => sheetCard(one, place)));
  showTaste();
}

function showEarly() {
  $("cards").replaceChildren(...early.map(([, card]) => {
    const made = make("article", { className: "card early" });
    made.append(picture(card, t("Layouts to choose from")), make("p", { className: "guess", textContent: t("one of those bred; twelve that differ are chosen when all are") }));
    return made;
  }));
}

function showAll() {
  $("cards").replaceChildren(...bred.sheets.flatMap((numbers, sheet) => [
    make("h3", { textContent: t("Sheet {n}", { n: sheet + 1 }) }), ...numbers.map((number) => smallCard(number))]));
}

// A picture of a layout; one with a number is a button to see it large.
function picture(card, name, number = null) {
  const svg = element("svg", { role: number === null ? "img" : "button", "aria-label": name });
  if (card) drawCard(card, svg);
  if (number === null) return svg;
  const large = () => enlarge([number]);
  svg.setAttribute("tabindex", 0);
  svg.addEventListener("click", large);
  svg.addEventListener("keydown", (event) => {
    if (![" ", "Enter"].includes(event.key)) return;
    event.preventDefault(); event.stopPropagation(); large();
  });
  return svg;
}

const saidOf = (number) => bred.said.filter((one) => [one.best, one.worst, one.candidate, one.one].includes(number));

function marks(number) {
  const found = saidOf(number), stars = found.findLast((one) => one.event === "stars");
  return [number === bred.champion ? t("your choice") : found.some((one) => one.event === "pick") ? t("liked") : "",
    found.some((one) => one.event === "worst") ? t("worst") : "",
    stars ? "★".repeat(stars.stars) : "",
    ...found.filter((one) => one.event === "reason").map((one) => one.reason)].filter(Boolean).join(" · ");
}

function frame(number, kind = "") {
  const names = ["card", kind, number === bred.champion ? "best" : "", saidOf(number).some((one) => one.event === "worst") ? "worst" : ""];
  return make("article", { className: names.filter(Boolean).join(" ") });
}

function smallCard(number) {
  const made = frame(number);
  made.title = marks(number);
  made.append(picture(known.get(number), [t("{name}, to see it large", { name: t("layout {n}", { n: number + 1 }) }), made.title].filter(Boolean).join(", "), number));
  return made;
}

const button = (text, title, act) => make("button", { textContent: text, title, onclick: act });

function sheetCard(one, place) {
  const made = Object.assign(frame(one.number), { role: "group", tabIndex: 0 }), name = place + 1, stars = saidOf(one.number).findLast((row) => row.event === "stars")?.stars ?? 0;
  const top = make("div", { className: "top" }, make("kbd", { textContent: KEYS[place] }),
    make("span", { className: "mark", textContent: marks(one.number) }));
  if (one.faults) top.append(make("span", { className: "bad", textContent: one.faults }));
  const rating = make("span", { className: "stars" }, ...[1, 2, 3, 4, 5].map((count) =>
    starButton(count, stars, () => tell(`${name}=${count}`))));
  const why = make("select", { title: t("What it lacks"), onchange: (event) => tell(`why ${name} ${event.target.value}`) },
    new Option(t("why…"), ""), ...bred.reasons.map((reason) => new Option(reason, reason)));
  const row = make("div", { className: "row" },
    button(t("Best"), t("key {key}", { key: KEYS[place] }), () => tell(`${name}`)), button(t("Worst"), t("Shift and key {key}", { key: KEYS[place] }), () => tell(`worst ${name}`)),
    rating, why, compareButton(one.number), useButton(() => choose(one.number)));
  if (!bred.reasons.length) why.remove();
  made.ariaLabel = [t("layout {n}, key {key}", { n: name, key: KEYS[place] }), marks(one.number), one.faults].filter(Boolean).join(", ");
  made.append(top, picture(known.get(one.number), t("{name}, to see it large", { name: t("layout {n}", { n: name }) }), one.number));
  if (one.predicted !== null) made.append(make("div", { className: "guess", title: t("what the model expects from what you said; no more"),
    textContent: t("predicted: {percent} % to be your pick", { percent: Math.round(100 * one.predicted) }) }));
  made.append(row);
  return made;
}

function starButton(count, stars, act) {
  const told = t("{n} of 5 stars", { n: count });
  return Object.assign(button(count <= stars ? "★" : "☆", told, act), { ariaLabel: told, ariaPressed: count === stars });
}

function useButton(act) {
  const made = button(t("Use"), t("take this layout to the plan"), act);
  made.className = "edits";
  return made;
}

function compareButton(number) {
  const made = button(pair.includes(number) ? t("Comparing…") : t("Compare"), t("with another one"), () => {
    pair = pair.includes(number) ? pair.filter((one) => one !== number) : [...pair, number].slice(-2);
    if (pair.length === 2) { enlarge(pair); pair = []; }
    show();
  });
  made.ariaPressed = pair.includes(number);
  return made;
}

function nameOf(number) {
  const place = bred.shown.findIndex((one) => one.number === number);
  return place < 0 ? t("layout {n}", { n: number + 1 }) : `${KEYS[place]}`;
}

async function enlarge(numbers) {
  const figures = numbers.map((number, k) => {
    const caption = make("figcaption", {}, make("strong", { textContent: nameOf(number) }), make("span", { className: "mark", textContent: marks(number) }));
    const places = numbers.map((one) => 1 + bred.shown.findIndex((row) => row.number === one));
    if (numbers.length === 2 && places.every(Boolean)) {
      caption.append(button(t("This one is better"), "", () => { $("large").close(); tell(`${places[k]} > ${places[1 - k]}`); }));
    }
    caption.append(useButton(() => { $("large").close(); choose(number); }));
    if (numbers.length === 1) caption.append(button(t("Compare with …"), t("then choose the other one"), () => { $("large").close(); pair = [number]; show(); }));
    return make("figure", {}, picture(known.get(number), nameOf(number)), caption);
  });
  if (numbers.length === 1 && pair.length === 1 && pair[0] !== numbers[0]) { const two = [pair[0], numbers[0]]; pair = []; show(); return enlarge(two); }
  $("pair").className = numbers.length === 1 ? "one" : "";
  $("pair").replaceChildren(...figures);
  $("differences").replaceChildren();
  $("large").showModal();
  if (numbers.length !== 2) return;
  const { differences = [] } = await send("compare", { one: numbers[0], other: numbers[1] });
  const told = differences.length ? differences.map((text) => `${nameOf(numbers[0])}: ${text}`) : [t("no difference that has words")];
  fill("differences", told, (text) => make("li", { textContent: text }));
}

function pieceOf(id) {
  const found = (bred.lockable ?? []).find((one) => one.id === id);
  return found ? `${found.name} (${found.space})` : id.split("/").at(-1).replaceAll("_", " ");
}

function words(one) {
  const name = (number) => nameOf(number);
  switch (one.event) {
    case "pick": return t("{one} is the best", { one: name(one.best) });
    case "worst": return t("{one} is the worst", { one: name(one.worst) });
    case "stars": return `${name(one.candidate)}: ${"★".repeat(one.stars)}`;
    case "reason": return `${name(one.candidate)}: ${one.reason}`;
    case "prefer": return t("{one} is better than {other}", { one: name(one.one), other: name(one.other) });
    case "lock": return t("{name} stays", { name: pieceOf(one.name) });
    default: return one.event;
  }
}

function showTaste() {
  const champion = bred.champion ?? null;
  $("champion").replaceChildren(...(champion === null ? [make("p", { textContent: t("none yet") })] :
    [smallCard(champion), useButton(() => choose(champion))]));
  fill("favourites", (bred.favourites ?? []).filter((one) => known.has(one)), smallCard);
  fill("said", (bred.said ?? []).slice(-12), (one) => make("li", { textContent: words(one) }));
  $("keep").hidden = !(bred.lockable ?? []).length;
  $("keep").replaceChildren(new Option(t("Keep in place…"), ""), ...(bred.lockable ?? []).map((one) => new Option(`${one.name} (${one.space})`, one.id)));
}

async function tell(line) {
  if (!bred.shown || bred.running) return;
  await send("say", { line, sheet: bred.sheet });
  await refreshBreeding();
}

async function choose(number) {
  const said = await send("choose", { number });
  if (!said.fault) { say(t("layout {name} is on the plan; Undo brings back what was there", { name: nameOf(number) })); await leave?.(); }
}

async function next() {
  if ($("next").disabled) return;
  bred.running = true; show();
  all = false;
  const said = await send("next");
  if (said.fault) await refreshBreeding();
}

$("next").onclick = next;
$("take-back").onclick = () => tell("undo");
$("sheets").onclick = () => { all = !all; show(); };
$("breeding-stop").onclick = () => send("stop");
$("keep").onchange = (event) => { if (event.target.value) tell(`lock ${event.target.value}`); };

document.addEventListener("keydown", (event) => {
  if ($("breeding").hidden || event.target.matches("input, select") || document.querySelector("dialog[open]")) return;
  const place = CODES.indexOf(event.code), command = event.ctrlKey || event.metaKey;
  if (command && event.key.toLowerCase() === "z") tell("undo");
  else if (command) return;
  else if (place >= 0 && place < (bred.shown ?? []).length && !all) tell(event.shiftKey ? `worst ${place + 1}` : `${place + 1}`);
  else if (event.key === "Enter" && !event.target.matches("button:not(#next)")) next();
  else return;
  event.preventDefault();
});
