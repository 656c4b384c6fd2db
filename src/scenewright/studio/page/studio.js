// The page: shows the server's document, sends verbs, listens to events. Lengths are metres, the
// plan's y points up, the screen's down.
import { drawFloor, drawShell, element, extent, line, outline, placed } from "/draw.js";
import { openShelf } from "/shelf.js";
import { followChange, unfold } from "/state.js";
import { $, fill, make, read, say, send } from "/wire.js";
import { hideBreeding, showBreeding, refreshBreeding, noteShare } from "/breed.js";
import { showWishes } from "/wishes.js";
import { notePhoto, offerPhoto, openLooks, takePhoto } from "/looks.js";
import { openPeople, refreshPeople } from "/people.js";
import { t } from "/words.js";
import { hideDrawing, refreshDrawing, showDrawing } from "/draft.js";

const NUDGE = 0.05, QUARTER = Math.PI / 2;

let room = "", measuring = false, ruler = null;
let doc = { version: 0 }, level = "", picked = "", more = new Set(), placing = "", view = null, drag = null, touched = false, changes = [];

async function change(verb, keys = {}) {
  const slow = setTimeout(() => { $("stop").hidden = false; }, 400);
  const said = await send(verb, keys, inWords).finally(() => clearTimeout(slow));
  changes = said.changes ?? [];
  await refresh();
  return said;
}

// Whoever waits for what it changed to be shown waits for the newest state: an older one is dropped.
let asked = 0, told = {}, newest = null;
async function refresh() {
  const mine = newest = readState();
  await mine;
  if (newest !== mine) await newest;
}

async function readState() {
  const turn = ++asked;
  const said = await read(`/state?since=${told.stamp ?? 0}`);
  if (turn !== asked) return;
  told = said.since ? followChange(told, said) : said;
  const fresh = await unfold(told);
  if (turn !== asked) return;
  if (fresh.name !== doc.name || !view !== !(fresh.levels ?? []).length) { view = null; touched = false; pick(""); }
  doc = fresh;
  if (!(doc.levels ?? []).some((one) => one.id === level)) level = doc.levels?.[0]?.id ?? "";
  show();
}

function show() {
  document.body.dataset.right = doc.me?.right ?? "view";
  $("name").textContent = doc.name || "Scenewright";
  $("undo").disabled = !doc.undo; $("redo").disabled = !doc.redo;
  $("adding").hidden = !(doc.levels ?? []).length; $("dress").hidden = doc.domain !== "home";
  $("arrange").disabled = $("breed").disabled = !(doc.levels ?? []).length || doc.running;
  for (const id of ["solid", "walk", "picture"]) $(id).disabled = !(doc.levels ?? []).length;
  $("export").inert = !(doc.levels ?? []).length;
  $("redraw").hidden = !doc.version || Boolean(doc.draft) || !doc.redraws;
  for (const id of ["stop", "share", "stage"]) $(id).hidden = !doc.running;
  if (!doc.running) $("stage").textContent = "";
  $("levels").replaceChildren(...((doc.levels ?? []).length > 1 ? doc.levels : []).map((one) => {
    const tab = document.createElement("button");
    tab.textContent = one.name || one.id; tab.role = "tab"; tab.ariaSelected = one.id === level;
    tab.onclick = () => { level = one.id; view = null; show(); };
    return tab;
  }));
  drawPlan(); showSelected(); showLists(); refreshDrawing(doc); mark3d();
  if (!$("space").hidden && spaceOf !== doc.version && !doc.running) showSpace($("walk").ariaPressed === "true");
}

function drawPlan() {
  const plan = $("plan"), here = (doc.levels ?? []).find((one) => one.id === level), focused = plan.contains(document.activeElement) && document.activeElement !== plan;
  plan.replaceChildren();
  if (!here) {
    plan.setAttribute("viewBox", "0 0 600 300");
    element("text", { class: "empty", x: 300, y: 150 }, plan, t("Draw a plan, bring one, or choose a sample."));
    return;
  }
  if (!view) view = extent(here);
  plan.setAttribute("viewBox", view.join(" "));
  drawFloor(here, plan);
  const bad = new Set((doc.findings ?? []).flatMap((found) => found.pieces));
  for (const piece of doc.pieces.filter((one) => one.level === level)) drawPiece(piece, bad, plan);
  drawShell(here, plan);
  for (const zone of doc.draft?.zones ?? []) {
    element("path", { class: "zone shown", d: outline([zone.outline]) }, plan);
    const [x, y] = zone.outline.reduce(([left, top], [px, py]) => [Math.min(left, px), Math.max(top, py)], [Infinity, -Infinity]), size = view[2] / 70;
    element("text", { class: "room zone-name", x: x + size, y: -y + 2 * size, "font-size": size }, plan, zone.name);
  }
  for (const one of here.spaces) {
    const [x, y] = one.label;
    element("text", { class: "room", x, y: -y, "font-size": view[2] / 55 }, plan, one.name);
  }
  if (focused && picked) plan.querySelector(`[data-id="${CSS.escape(picked)}"]`)?.focus();
  drawFindings(toShow());
  if (!doc.running) { streamed.clear(); plan.classList.remove("searching"); }
  drawStreamed();
}

// The best layouts found so far while something is arranged: boxes, by space.
const streamed = new Map();
function drawStreamed() {
  const plan = $("plan");
  plan.querySelector("#streamed")?.remove();
  if (!doc.running || !view) return;
  const layer = element("g", { id: "streamed" }, plan), here = doc.levels.find((one) => one.id === level);
  const inside = new Set(here?.spaces.map((one) => one.id));
  for (const [space, boxes] of streamed) if (inside.has(space)) for (const [name, x, y, heading, width, depth] of boxes) {
    const group = element("g", { transform: placed([x, y, 0, heading]) }, layer);
    element("rect", { class: "searched", x: -width / 2, y: -depth / 2, width, height: depth }, group);
    element("title", {}, group, name.replaceAll("_", " "));
  }
  plan.classList.toggle("searching", streamed.size > 0);
}

// Where findings lie: the part that is at fault, and what is looked at after a click.
function drawFindings(findings) {
  const plan = $("plan"), first = doc.levels[0]?.id;
  plan.querySelector("#faults-layer")?.remove();
  const layer = element("g", { id: "faults-layer" }, plan);
  for (const found of findings) {
    if ((found.level || first) !== level) continue;
    for (const ring of found.polygons) element("path", { class: found.blamed ? "wrong" : "wrong warns", d: outline([ring]) }, layer);
    if (!found.polygons.length) for (const [x, y] of found.points) element("circle", { class: "wrong", cx: x, cy: -y, r: view[2] / 90 }, layer);
  }
  return layer;
}

// The ruler: what lies between two places, in metres.
function drawRuler() {
  const plan = $("plan");
  plan.querySelector("#ruler")?.remove();
  if (!ruler) return;
  const [[ax, ay], [bx, by]] = ruler, layer = element("g", { id: "ruler" }, plan), size = view[2] / 45;
  element("path", { class: "guide", d: line(ruler) }, layer);
  for (const [x, y] of ruler) element("circle", { class: "hold", cx: x, cy: -y, r: view[2] / 200 }, layer);
  element("text", { class: "title", x: (ax + bx) / 2, y: -(ay + by) / 2 - size / 2, "font-size": size }, layer, `${Math.hypot(bx - ax, by - ay).toFixed(2)} m`);
}

function measure(on) {
  measuring = on; ruler = null; $("measure").ariaPressed = on; $("plan").classList.toggle("placing", on); drawRuler();
  if (on) say(t("drag from one place to another"));
}
$("measure").onclick = () => measure(!measuring);

// Of a plan that is not furnished yet only what is wrong with itself: all else is missing, of course.
const toShow = () => (doc.findings ?? []).filter((found) => !isBare() || found.kind !== "missing" && (doc.pieces.length || !found.pieces.length));

function lookAt(found) {
  if (!found.points.length) return;
  level = found.level || level;
  const [x, y] = found.points[0], size = Math.min(view[2], 5), tall = size * view[3] / view[2];
  view = [x - size / 2, -y - tall / 2, size, tall];
  show();
  const layer = $("faults-layer") ?? $("plan");
  for (const [px, py] of found.points) element("circle", { class: "look", cx: px, cy: -py, r: size / 14 }, layer);
}

function drawPiece(piece, bad, plan) {
  const names = ["piece", piece.flat && "flat", piece.hangs && "hangs", piece.locked && "locked",
    bad.has(piece.id) && "bad", (piece.id === picked || more.has(piece.id)) && "on"].filter(Boolean).join(" ");
  const where = doc.levels.flatMap((one) => one.spaces).find((one) => one.id === piece.space)?.name ?? "";
  const spoken = [piece.name, where, piece.locked ? t("locked") : "", bad.has(piece.id) ? t("at fault") : ""].filter(Boolean).join(", ");
  const group = element("g", { class: names, transform: placed(piece.pose), "data-id": piece.id, tabindex: 0, role: "button", "aria-label": spoken, "aria-pressed": piece.id === picked }, plan);
  element("title", {}, group, piece.name);
  for (const points of piece.lines) element("path", { d: line(points) }, group);
}

const chosen = () => doc.pieces?.find((piece) => piece.id === picked);
const selection = () => (doc.pieces ?? []).filter((piece) => piece.id === picked || more.has(piece.id));
const ids = () => selection().map((piece) => piece.id);
function pick(id) { picked = id; more = new Set(); room = chosen()?.space ?? room; }

function showSelected() {
  const piece = chosen();
  $("selected").hidden = !piece;
  if ($("drawing").hidden) showAsked(piece);
  if (!piece) return;
  const [x, y, , heading] = piece.pose, [w, d, h] = piece.size;
  const several = selection().length;
  $("piece").textContent = several > 1 ? t("{n} pieces", { n: several }) : piece.name;
  $("place").hidden = $("sizes").hidden = $("exchange").hidden = several > 1;
  for (const [id, value] of [["wide", w], ["deep", d], ["high", h]]) if (document.activeElement !== $(id)) $(id).value = Number(value.toFixed(3));
  for (const [id, value] of [["at-x", x], ["at-y", y], ["at-turn", Math.round(heading * 180 / Math.PI)]]) {
    if (document.activeElement !== $(id)) $(id).value = Number(value.toFixed(3));
  }
  $("measures").textContent = several > 1 ? t("Shift and a click adds or takes away") : `${w.toFixed(2)} × ${d.toFixed(2)} × ${h.toFixed(2)} m`;
  $("fit").hidden = several > 1 || !(doc.findings ?? []).some((found) => found.blamed && found.pieces.includes(piece.id));
  $("fit-here").hidden = !$("plan").querySelector("#fits");
  $("lock").textContent = piece.locked ? t("Unlock") : t("Lock");
}

// What the room of the selected piece is asked for, or the one clicked, or the only one.
function showAsked(piece) {
  const spaces = (doc.levels ?? []).flatMap((one) => one.spaces), here = spaces.find((one) => one.id === (piece?.space ?? room)) ?? (spaces.length === 1 ? spaces[0] : null);
  showWishes(here, doc.domain, here && doc.wishes?.[here.id], (wishes) => change("wish", { space: here.id, wishes }), { zones: doc.draft?.zones });
}

function item(text, pieces = [], bad = false) {
  const row = document.createElement("li"), button = document.createElement("button");
  button.textContent = text; if (bad) row.className = "bad";
  button.onclick = () => {
    const found = doc.pieces.find((piece) => pieces.includes(piece.id));
    if (found) { pick(found.id); level = found.level; show(); }
  };
  row.append(button);
  return row;
}

// Words for a person: pieces by what they are, not by their ids.
function inWords(text) {
  const named = (doc.pieces ?? []).filter((piece) => text.includes(piece.id)).sort((a, b) => b.id.length - a.id.length);
  return named.reduce((told, piece) => told.replaceAll(`'${piece.id}'`, t("the {piece}", { piece: piece.name })).replaceAll(piece.id, t("the {piece}", { piece: piece.name })), text);
}

function listFinding(found) {
  const row = item(inWords(found.message), found.pieces, found.blamed), select = row.firstChild.onclick;
  row.firstChild.onclick = () => { select(); lookAt(found); };
  if (found.blamed && !drag && ["edit", "own"].includes(document.body.dataset.right)) row.append(acceptButton(found));
  return row;
}

// A person who means it so says why; the brief keeps the reason.
function acceptButton(found) {
  const button = document.createElement("button");
  button.textContent = t("Accept…"); button.className = "accept";
  button.onclick = () => {
    const reason = prompt(t("Why is this meant to be so?"))?.trim();
    if (reason) change("accept", { kind: found.kind, piece: found.pieces[0] ?? "", space: found.space, reason });
  };
  return button;
}

// Before anything is arranged all is missing, which says nothing.
const isBare = () => (doc.levels ?? []).length > 0 && doc.pieces.every((piece) => piece.locked);

// Many changes of one kind for one reason are told as one.
function gather(rows) {
  const alike = Map.groupBy ? [...Map.groupBy(rows, (one) => `${one.change}${one.reason}`).values()] : rows.map((one) => [one]);
  return alike.flatMap((group) => group.length > 5 ? [{ ...group[0], count: group.length, n: group.length }] : group);
}

function showLists() {
  $("verdict").textContent = doc.running ? t("arranging …") : isBare() ? ["view", "rate"].includes(doc.me?.right) ? t("nothing is arranged yet") : t("nothing is arranged yet: press Arrange") : doc.verdict ?? "";
  fill("findings", toShow(), listFinding);
  fill("left-out", doc.left_out ?? [], (out) => item(`${out.what.replaceAll("_", " ")}: ${out.reason}`, [], out.required));
  fill("changes", gather(changes), (one) => one.count ? item(t("{n} pieces {change}: {reason}", one)) : item(inWords(`${one.piece} ${one.change}: ${one.reason}`).replaceAll("_", " "), [one.piece]));
  $("reading").hidden = !doc.read?.length;
  fill("read-rows", doc.read ?? [], (row) => make("li", { textContent: row.text, className: row.lost ? "bad" : "" }));
  fill("history", doc.history ?? [], (step) => {
    const row = item(step.what);
    row.ariaCurrent = step.id === doc.version;
    row.firstChild.onclick = () => change("go", { version: step.id });
    return row;
  });
}

// Moving by pointer: the piece follows, the referee is asked for the latest place only.
function planPoint(event) {
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform($("plan").getScreenCTM().inverse());
  return [point.x, -point.y];
}

$("plan").addEventListener("pointerdown", (event) => {
  const group = event.target.closest?.(".piece"), at = planPoint(event);
  $("plan").setPointerCapture(event.pointerId);
  if (measuring) { ruler = [at, at]; drawRuler(); return; }
  if (placing) {
    const asset = placing;
    placing = ""; $("plan").classList.remove("placing"); say("");
    change("add", { asset, at }).then(({ changes: told = [] }) => { if (told.length) { pick(told[0].piece); show(); } });
  } else if (group && event.shiftKey) {
    const id = group.dataset.id;
    if (id === picked || more.has(id)) { more.delete(id); if (id === picked) { picked = [...more][0] ?? ""; more.delete(picked); } }
    else if (picked) more.add(id); else picked = id;
    show();
  } else if (group) {
    if (!more.has(group.dataset.id)) pick(group.dataset.id);
    else { more.add(picked); picked = group.dataset.id; more.delete(picked); }
    const piece = chosen();
    drag = { piece, from: at, start: [...piece.pose], moved: false, all: selection().map((one) => ({ one, start: [...one.pose] })) };
    show();
  } else {
    drag = { pan: true, from: [event.clientX, event.clientY], start: [...view ?? [0, 0, 1, 1]] };
    pick(""); room = event.target.closest?.(".space")?.dataset.space ?? room; show();
  }
});

$("plan").addEventListener("pointermove", (event) => {
  if (measuring && ruler && event.buttons) { ruler[1] = planPoint(event); drawRuler(); return; }
  if (!drag) return;
  if (drag.pan) {
    const scale = drag.start[2] / $("plan").clientWidth;
    view = [drag.start[0] - (event.clientX - drag.from[0]) * scale,
      drag.start[1] - (event.clientY - drag.from[1]) * scale, drag.start[2], drag.start[3]];
    $("plan").setAttribute("viewBox", view.join(" "));
    return;
  }
  const [x, y] = planPoint(event);
  moveBy(x - drag.from[0], y - drag.from[1], event.altKey);
});

// What is dragged stands elsewhere, and the referee is asked.
function moveBy(right, up, fine) {
  const step = fine ? 0.001 : 0.05, snap = (value) => Math.round(value / step) * step, dx = snap(right), dy = snap(up);
  if (!dx && !dy && !drag.moved) return;
  drag.moved = true;
  for (const { one, start } of drag.all) {
    one.pose = [start[0] + dx, start[1] + dy, start[2], start[3]];
    document.querySelector(`[data-id="${CSS.escape(one.id)}"]`)?.setAttribute("transform", placed(one.pose));
  }
  showSelected(); ask();
}

let asking = false, latest = null;
async function ask() {
  latest = chosen();
  if (asking || !latest) return;
  asking = true;
  while (latest) {
    const piece = latest; latest = null;
    const said = await send("judge", { poses: posesOf(selection()) });
    const found = said.findings ?? [];
    document.querySelector(`[data-id="${CSS.escape(piece.id)}"]`)?.classList.toggle("bad", found.length > 0);
    if (drag) { fill("findings", found, listFinding); drawFindings(found); mark3d(found.length > 0); }
  }
  asking = false;
}

async function drop() {
  const done = drag; drag = null;
  if (done?.moved) await place(done.piece);
}
$("plan").addEventListener("pointerup", drop);

const posesOf = (pieces) => Object.fromEntries(pieces.map(({ id, pose: [x, y, , heading] }) => [id, [x, y, heading]]));

async function place(piece) {
  const names = [piece.id, ...more], poses = posesOf(selection()), said = await change("move", { poses });
  if (said.fault) { if (names.length === 1) await offerFit(piece.id, poses[piece.id], inWords(said.fault)); return; }
  const now = names.map((name) => (said.changes ?? []).find((one) => one.was === name)?.piece ?? name);
  picked = now[0]; more = new Set(now.slice(1)); show();
}

// Where a piece fits, near a place where it does not: drawn on the plan, taken by a click.
async function offerFit(id, wanted, fault = "") {
  const { pose } = await send("fit", { piece: id, pose: wanted }), piece = doc.pieces.find((one) => one.id === id);
  if (!pose || !piece) { say([fault, t("no place near fits")].filter(Boolean).join("; ")); return; }
  $("plan").querySelector("#fits")?.remove();
  const ghost = element("g", { id: "fits", class: "fits", transform: placed([pose[0], pose[1], 0, pose[2]]), role: "button", "aria-label": t("the nearest place that fits") }, $("plan"));
  element("title", {}, ghost, t("the nearest place that fits"));
  for (const points of piece.lines) element("path", { d: line(points) }, ghost);
  $("fit-here").hidden = false;
  $("fit-here").onclick = ghost.onpointerdown = (event) => { event.stopPropagation(); $("fit-here").hidden = true; ghost.remove(); change("move", { poses: { [id]: pose } }); };
}
$("fit").onclick = () => { const piece = chosen(); if (piece) offerFit(piece.id, posesOf([piece])[piece.id]); };

$("plan").addEventListener("wheel", (event) => {
  if (!view) return;
  event.preventDefault();
  const [x, y] = planPoint(event), by = Math.exp(event.deltaY * 0.0012);
  view = [x + (view[0] - x) * by, -y + (view[1] + y) * by, view[2] * by, view[3] * by];
  $("plan").setAttribute("viewBox", view.join(" "));
}, { passive: false });

document.addEventListener("keydown", (event) => {
  if (event.target.matches("input, select") || document.querySelector("dialog[open]") || $("plan").hasAttribute("hidden") && $("space").hidden && $("drawing").hidden || $("walk").ariaPressed === "true") return;
  const piece = chosen(), key = event.key.toLowerCase(), command = event.ctrlKey || event.metaKey;
  const way = { arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, 1], arrowdown: [0, -1] }[key];
  if (command && key === "z" && !event.shiftKey) change("undo");
  else if (command && (key === "y" || key === "z")) change("redo");
  else if (!$("drawing").hidden) return;
  else if (!command && key === "m" && !$("plan").hasAttribute("hidden")) measure(!measuring);
  else if (key === "home") { view = null; show(); }
  else if (key === "escape") { measure(false); placing = ""; $("plan").classList.remove("placing"); pick(""); show(); }
  else if (piece && command && key === "d") $("double").click();
  else if (command) return;
  else if (piece && (key === "delete" || key === "backspace")) $("remove").click();
  else if (piece && way) nudge(piece, way[0] * NUDGE, way[1] * NUDGE, 0);
  else if (piece && key === "r") nudge(piece, 0, 0, event.shiftKey ? -QUARTER : QUARTER);
  else if (piece && key === "l") $("lock").click();
  else return;
  event.preventDefault();
});

function nudge(piece, dx, dy, turn) {
  for (const one of selection()) {
    const [x, y, z, heading] = one.pose;
    one.pose = [x + dx, y + dy, z, heading + turn];
  }
  return place(piece);
}

$("arrange").onclick = () => change("arrange", { seed: Number($("seed").value) || 0 });
$("stop").onclick = () => send("stop");
$("undo").onclick = () => change("undo");
$("redo").onclick = () => change("redo");
$("turn").onclick = () => { const piece = chosen(); if (piece) nudge(piece, 0, 0, QUARTER); };
$("lock").onclick = () => { const piece = chosen(); if (piece) change(piece.locked ? "unlock" : "lock", { pieces: ids() }); };
$("remove").onclick = () => { const pieces = ids(); pick(""); change("remove", { pieces }); };
$("double").onclick = async () => {
  const { changes: told = [] } = await change("duplicate", { pieces: ids() });
  if (told.length) { pick(told[0].piece); more = new Set(told.slice(1).map((one) => one.piece)); show(); }
};
$("exchange").onclick = () => {
  const piece = chosen();
  openShelf(t("In place of the {piece}", { piece: piece.name }), piece.category, ({ asset }) => change("exchange", { piece: piece.id, asset }));
};
$("add").onclick = () => openShelf(t("Add furniture"), "", ({ asset, name }) => {
  placing = asset; $("plan").classList.add("placing"); say(t("{name}: click where it is to stand", { name }));
});
for (const id of ["at-x", "at-y", "at-turn"]) $(id).onchange = () => {
  const piece = chosen(), [x, y, turn] = ["at-x", "at-y", "at-turn"].map((one) => Number($(one).value));
  if (!piece) return;
  piece.pose = [x, y, piece.pose[2], turn * Math.PI / 180];
  place(piece);
};
for (const id of ["wide", "deep", "high"]) $(id).onchange = () => {
  const piece = chosen();
  if (piece) change("resize", { piece: piece.id, size: ["wide", "deep", "high"].map((one) => Number($(one).value)) });
};
$("style").onchange = async () => {
  const piece = chosen(), style = $("style").value;
  $("style").value = "";
  if (piece && style) await change("restyle", { piece: piece.id, style });
};
$("plan").addEventListener("focusin", (event) => {
  const id = event.target.closest?.(".piece")?.dataset.id;
  if (id && id !== picked && !drag) { pick(id); show(); }
});
$("again").onclick = () => {
  const piece = chosen();
  if (piece) change("again", { space: piece.space, seed: 1 + Math.floor(Math.random() * 999) });
};
// The scene in 3D, made again when another version is shown; walked through from the selected
// piece's room, or from the first one.
let space = null, spaceOf = 0;

async function showSpace(walking) {
  if (!doc.version) return;
  hideBreeding(); hideDrawing();
  for (const [id, on] of [["space", true], ["pad", walking && matchMedia("(pointer: coarse)").matches]]) $(id).hidden = !on;
  if (walking) $("minimap").removeAttribute("hidden"); else $("minimap").setAttribute("hidden", "");
  $("plan").setAttribute("hidden", "");
  $("solid").ariaPressed = !walking; $("walk").ariaPressed = walking; offerPhoto(walking, doc.walls);
  if (!space || spaceOf !== doc.version) {
    say(t("building the scene …"));
    const stood = space?.walking ? space.where() : null, version = doc.version;
    if (!space) { const { open3d } = await import("/walk.js"); space = open3d($("space"), hands); }
    await space.show(await read("/solid")); mark3d();
    spaceOf = version; space.stood = stood;
    say("");
  }
  space.walking = walking;
  if (!walking) { space.turn(); return; }
  const room = roomToStandIn(), [x, y, heading] = space.stood ?? space.eyes[room.id] ?? [...room.label, facing(room.label)];
  space.walk(x, y, room.floor, heading);
  drawMinimap();
  $("space").focus();
}

// Pieces in the 3D view: meshes there are of whole rooms, so what is meant is found by its box.
const floorOf = (piece) => doc.levels.find((one) => one.id === piece.level)?.elevation ?? 0;
function holds({ pose: [x, y, z, heading], size: [width, depth, height], ...piece }, [px, py, pz]) {
  const [c, s] = [Math.sin(heading), -Math.cos(heading)], [dx, dy] = [px - x, py - y], up = pz - z - floorOf(piece), near = 0.02;
  return Math.abs(c * dx + s * dy) < width / 2 + near && Math.abs(c * dy - s * dx) < depth / 2 + near && up > -near && up < height + near;
}
const bulk = ({ size: [w, d, h] }) => w * d * Math.max(h, 0.01);
const pieceAt = (at) => (doc.pieces ?? []).filter((one) => holds(one, at)).sort((a, b) => bulk(a) - bulk(b))[0];
function mark3d(bad = false) {
  if ($("space").hidden) return;
  space?.mark(selection().map((one) => [one.pose[0], one.pose[1], one.pose[2] + floorOf(one), one.pose[3], ...one.size]), bad);
}
const hands = {
  point(at) { pick(pieceAt(at)?.id ?? ""); level = chosen()?.level ?? level; show(); },
  grab(at) {
    const piece = document.body.dataset.right === "view" || doc.running ? null : pieceAt(at);
    if (!piece || !ids().includes(piece.id)) return false;
    drag = { piece, moved: false, all: selection().map((one) => ({ one, start: [...one.pose] })) };
    return true;
  },
  drag(dx, dy, event) { moveBy(dx, dy, event.altKey); mark3d(); },
  drop,
};

// Towards the middle of the level.
function facing([x, y]) {
  const here = doc.levels.find((one) => one.id === level) ?? doc.levels[0], [left, top, width, height] = extent(here);
  return Math.atan2(-(top + height / 2) - y, left + width / 2 - x);
}

// Where one stands while walking, on a small plan; a click goes there.
function drawMinimap() {
  const map = $("minimap"), here = doc.levels.find((one) => one.id === level) ?? doc.levels[0], frame = extent(here);
  map.setAttribute("viewBox", frame.join(" "));
  map.replaceChildren();
  drawFloor(here, map);
  for (const piece of doc.pieces.filter((one) => one.level === here.id && !one.hangs)) element("path", { class: "item", d: piece.lines.map(line).join(""), transform: placed(piece.pose) }, map);
  drawShell(here, map);
  const dot = element("path", { class: "here", d: `M0,${-frame[2] / 16} L${frame[2] / 28},${frame[2] / 28} L${-frame[2] / 28},${frame[2] / 28}Z` }, map);
  const follow = () => {
    if (map.hasAttribute("hidden") || !space?.walking) return;
    const [x, y, heading] = space.where();
    dot.setAttribute("transform", `translate(${x} ${-y}) rotate(${90 - heading * 180 / Math.PI})`);
    requestAnimationFrame(follow);
  };
  follow();
  map.onclick = (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(map.getScreenCTM().inverse());
    space.walk(at.x, -at.y, here.elevation, space.where()[2]);
  };
}

function roomToStandIn() {
  const piece = chosen(), here = doc.levels.find((one) => one.id === level) ?? doc.levels[0];
  const room = here.spaces.find((one) => one.id === piece?.space) ?? here.spaces[0];
  return { id: room.id, label: room.label, floor: here.elevation };
}

function showPlan() {
  if (!$("drawing").hidden && !touched) view = null;
  for (const id of ["space", "pad"]) $(id).hidden = true;
  $("minimap").setAttribute("hidden", "");
  hideBreeding(); hideDrawing();
  $("plan").removeAttribute("hidden");
  $("solid").ariaPressed = $("walk").ariaPressed = false;
  offerPhoto(false);
}

$("solid").onclick = () => $("solid").ariaPressed === "true" ? showPlan() : showSpace(false);
$("walk").onclick = () => $("walk").ariaPressed === "true" ? showPlan() : showSpace(true);
for (const button of $("pad").children) {
  for (const [kind, on] of [["pointerdown", true], ["pointerup", false], ["pointerleave", false]]) {
    button.addEventListener(kind, () => space?.press(button.dataset.key, on));
  }
}

$("draw").onclick = () => {
  if ($("draw").ariaPressed === "true") showPlan();
  else if (doc.draft) goDraw();
  else $("kinds-of-plan").showModal();
};
$("redraw").onclick = async () => {
  $("kinds-of-plan").close();
  const said = await change("redraw");
  if (!said.fault) goDraw();
};
$("new-plan").onclick = () => $("kinds-of-plan").showModal();
for (const button of document.querySelectorAll("[data-kind]")) button.onclick = async () => {
  $("kinds-of-plan").close();
  const said = await change("begin", { kind: button.dataset.kind });
  if (!said.fault) goDraw();
};

function goDraw() {
  showPlan();
  $("plan").setAttribute("hidden", "");
  showDrawing(doc, change);
}
$("furnish").onclick = () => { showPlan(); $("arrange").click(); };

$("breed").onclick = async () => {
  if ($("breed").ariaPressed === "true") { showPlan(); return; }
  if (!doc.version) return;
  showPlan();
  $("plan").setAttribute("hidden", "");
  await showBreeding(async () => { showPlan(); await refresh(); });
};

$("picture").onclick = async () => {
  let picture = $("space").hidden ? null : await space?.shot();
  if (!picture) {
    say(t("drawing …"));
    const reply = await fetch("/picture.png");
    if (!reply.ok) { say((await reply.json()).fault); return; }
    picture = await reply.blob();
  }
  say(""); $("image").src = $("keep-picture").href = URL.createObjectURL(picture); $("shown").showModal();
};
$("photo").onclick = () => takePhoto(space.where(), (doc.levels.find((one) => one.id === level) ?? doc.levels[0]).elevation);
$("dress").onclick = () => openLooks(change);
$("samples").onchange = async (event) => { if (event.target.value) await change("open", { source: event.target.value }); };
$("file").onchange = (event) => bring(event.target.files[0]);
document.addEventListener("dragover", (event) => event.preventDefault());
document.addEventListener("drop", (event) => { event.preventDefault(); bring(event.dataTransfer.files[0]); });

async function bring(file) {
  if (!file) return;
  const reply = await fetch(`/bring?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file });
  const said = await reply.json().catch(() => ({ fault: t("the studio answered {status}", { status: reply.status }) }));
  if (said.fault) say(said.fault);
  await refresh();
  const lost = said.fault ? 0 : (doc.read ?? []).filter((row) => row.lost).length;
  $("reading").querySelector("details").open = lost > 0;
  if (lost) say(t("not all of the file could be read: see below Read from the file"));
}

// What is made ready meanwhile: the first search need not wait for it, but will.
function noteReady({ kind, first }) {
  $("ready").hidden = !kind;
  $("ready").textContent = !kind ? "" : first ? t("compiling, once on this machine: the first search waits for it …") : t("getting ready …");
}

// What is done while something is arranged: the stage, its room, and why it changed.
const STAGES = { search: t("searching"), fit: t("fitted"), routes: t("routes"), repair: t("mended"), settled: t("settled"), "left out": t("Left out") };
function noteStage({ space, stage, reason }) {
  const room = (doc.levels ?? []).flatMap((one) => one.spaces).find((one) => one.id === space);
  $("stage").textContent = $("stage").title = [STAGES[stage], room?.name ?? space, reason].filter(Boolean).join(" · ");
}

const events = new EventSource("/events");
events.onmessage = (message) => {
  const event = JSON.parse(message.data);
  if (event.changed && doc.me?.right !== "rate") refresh();
  if (event.bred) { refreshBreeding(); refreshPeople(); }
  if (event.rated) refreshPeople();
  if (event.ready) noteReady(event.ready);
  if (event.photo !== undefined && !["rate", "view"].includes(document.body.dataset.right)) notePhoto(event.photo);
  if (event.fault || event.notice) say(event.fault ?? event.notice);
  if (event.stage) noteStage(event);
  if (event.boxes) { streamed.set(event.space, event.boxes); if (doc.running) drawStreamed(); }
  if (event.share !== undefined) { $("share").value = event.share; $("share").title = event.what; noteShare(event.share); }
};
events.onerror = () => say(t("the studio does not answer; start it again and use its new link"));

$("invite-people").onclick = () => openPeople(refresh);

for (const name of await read("/samples")) $("samples").append(new Option(name.replace("sample:", ""), name));
noteReady(await read("/ready"));
await refresh();
// Whoever has a link to rate sees the sheets, and nothing else.
if (doc.me?.right === "rate") { $("plan").setAttribute("hidden", ""); await showBreeding(async () => {}); }
