// What a room, hall, site or block is asked for: a list of rows and a few numbers, by forms made from
// the JSON Schema of each.
import { $, fill, make, read } from "/wire.js";
import { t } from "/words.js";

const WORDS = { what: t("what"), forbid: t("never"), required: t("must be there"), by: t("beside a"), near: t("near"), face: t("facing"), away_from: t("away from"), metres: t("metres"),
  category: t("what"), count: t("how many"), length: t("metres of front"), most: t("at most"), fill: t("share of floor"), size: t("wide × deep × high"), clearance: t("free around, m"), place: t("at a wall or free"),
  patterns: t("patterns"), zone: t("zone"), facing: t("facing"), name: t("called"), model: t("model"), floors: t("storeys"), forms: t("forms"), theme: t("theme"), people: t("people"), used_from: t("used from"),
  floor_area_ratio: t("floor-area ratio"), coverage: t("share built on"), height_limit: t("height limit, m"), setback: t("setback, m"), road_setback: t("setback from streets, m"), spacing: t("between buildings, m"),
  form: t("form of blocks"), square: t("square, m²"), storeys: t("storeys more") };
const HEADS = { wishes: t("Wish or forbid something…"), demands: t("Ask for something…"), buildings: t("Ask for buildings…") };
const FIRST = ["what", "forbid", "required", "by", "near", "category", "count", "length", "zone", "place", "model", "size"], SKIPPED = ["id", "footprint"];
const schemas = new Map();
let place = null, asked = {}, put = null, schema = null, made = "", zones = [];

// ``one`` is the place, with what it is ``asked`` for by key; ``act`` is given all of it anew.
export async function showWishes(one, domain, given, act, of = {}) {
  $("wishing").hidden = !one || !given;
  if ($("wishing").hidden) return;
  zones = of.zones ?? [];
  const wanted = `${domain} ${zones.map((zone) => zone.name)}`;
  if (place?.id !== one.id || made !== wanted) { place = one; made = wanted; await makeForms(domain); }
  if (!schema || made !== wanted) return;
  place = one; asked = given; put = act;
  $("wish-room").textContent = t("Wishes for {room}", { room: one.name || one.id });
  const rows = asked[schema.rows] ?? [];
  fill("wish-list", rows, (row, k) => make("li", {}, told(row), " ", make("button", { textContent: "×", title: t("Remove"), ariaLabel: t("Remove"), onclick: () => put({ ...asked, [schema.rows]: rows.filter((_, n) => n !== k) }) })));
  for (const field of $("wish-keys").elements) if (field.name && document.activeElement !== field) show(field, asked[field.name]);
}

const joined = (value) => value.join(typeof value[0] === "number" ? " × " : ", ");
const told = (row) => Object.entries(row).filter(([key]) => !["id", "clearance", "footprint"].includes(key) && !(row.required === false && ["name", "size"].includes(key))).map(([key, value]) => {
  if (key === "required") return value ? WORDS[key] : t("if there is room");
  if (value === true) return WORDS[key] ?? key;
  const words = key === "zone" ? zones.find((one) => one.id === value)?.name ?? value : Array.isArray(value) ? joined(value) : typeof value === "object" ? "…" : String(value).replaceAll("_", " ");
  return ["what", "category", "model"].includes(key) ? words : `${WORDS[key] ?? key.replaceAll("_", " ")} ${words}`;
}).join(" · ");

async function makeForms(domain) {
  if (!schemas.has(domain)) schemas.set(domain, await read(`/wish.schema.json?of=${domain}`));
  schema = schemas.get(domain);
  const keys = fields(schema.keys.properties, schema.keys), rows = schema.row ? fields(schema.row.properties, schema.row) : [];
  $("wish-keys").replaceChildren(...keys);
  $("wish-more").hidden = !rows.length;
  $("wish-head").textContent = HEADS[schema.rows] ?? "";
  const first = rows.filter((label) => FIRST.includes(label.dataset.key)), rest = rows.filter((label) => !first.includes(label));
  const more = rest.length ? [make("details", {}, make("summary", { textContent: t("more") }), ...rest)] : [];
  $("wish").replaceChildren(...first, ...more, make("button", { textContent: t("Wish for it"), className: "main" }));
  const named = [...new Set((await read("/shelf")).map((row) => row.category))].sort();
  $("kinds").replaceChildren(...named.map((name) => new Option(name.replaceAll("_", " "), name)));
}

const plain = (one) => one.anyOf?.find((each) => each.type !== "null") ?? one;

function fields(properties, { $defs = {}, required = [] }) {
  return Object.entries(properties).filter(([key]) => !SKIPPED.includes(key)).map(([key, given]) => field(key, given, plain(given), $defs, required.includes(key))).filter(Boolean);
}

function field(key, given, one, defs, needed) {
  const items = plain(one.items ?? one.prefixItems?.[0] ?? {}), choices = one.enum ?? (one.$ref && defs[one.$ref.split("/").at(-1)]?.enum);
  if (one.$ref && !choices || one.type === "object" || one.type === "array" && items.type !== "number" && items.type !== "string") return null;
  const rows = key === "zone" && zones.length ? zones.map((zone) => new Option(zone.name, zone.id)) : choices?.map((value) => new Option(String(value).replaceAll("_", " "), value));
  const input = rows ? make("select", {}, new Option("–", ""), ...rows)
    : make("input", { type: { boolean: "checkbox", number: "number", integer: "number" }[one.type] ?? "text", step: one.type === "integer" ? 1 : "any" });
  Object.assign(input, { name: key, required: needed });
  input.dataset.kind = one.type === "array" ? items.type === "string" ? "words" : "numbers" : one.type ?? "string";
  if (one.minimum !== undefined) input.min = one.minimum;
  if (given.default === true) { input.defaultChecked = true; input.dataset.usual = "true"; }
  const words = schema.choices[key] ?? [], list = ["what", "category", "model"].includes(key) ? "kinds" : words.length ? `words-${key}` : "";
  if (list) input.setAttribute("list", list);
  if (words.length && !$(list)) document.body.append(make("datalist", { id: list }, ...words.map((word) => new Option(word, word))));
  const label = make("label", {}, `${WORDS[key] ?? key.replaceAll("_", " ")} `, input);
  label.dataset.key = key;
  return label;
}

function show(input, value) {
  if (input.type === "checkbox") input.checked = value ?? input.dataset.usual === "true";
  else input.value = Array.isArray(value) ? joined(value) : value ?? "";
}

// What a field holds, undefined where it says nothing.
function valueOf(input) {
  const text = input.value.trim();
  if (input.type === "checkbox") return input.checked === (input.dataset.usual === "true") ? undefined : input.checked;
  if (!text) return undefined;
  if (input.type === "number") return Number(text);
  if (input.dataset.kind === "numbers") return text.split(/[^\d.-]+/).filter(Boolean).map(Number);
  return input.dataset.kind === "words" ? text.split(/[,;]\s*/) : text;
}

$("wish").onsubmit = async (event) => {
  event.preventDefault();
  const row = {};
  for (const input of $("wish").elements) if (input.name && valueOf(input) !== undefined) row[input.name] = valueOf(input);
  const said = await put({ ...asked, [schema.rows]: [...asked[schema.rows] ?? [], row] });
  if (!said.fault) $("wish").reset();
};
$("wish-keys").onsubmit = (event) => event.preventDefault();
$("wish-keys").onchange = ({ target }) => {
  const { [target.name]: _, ...rest } = asked, value = valueOf(target);
  put(value === undefined ? rest : { ...rest, [target.name]: value });
};
