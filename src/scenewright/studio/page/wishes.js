// Wishes of a room: a list, and a form made from the JSON Schema of a wish.
import { $, fill, make, read } from "/wire.js";
import { t } from "/words.js";

const WORDS = { what: t("what"), forbid: t("never"), required: t("must be there"), by: t("beside a"), near: t("near"), face: t("facing"), away_from: t("away from"), metres: t("metres") };
let schema = null, rows = [], change = null, room = "";

export async function showWishes(space, doc, act) {
  $("wishing").hidden = !space || !doc.wishes?.[space.id];
  if ($("wishing").hidden) return;
  if (room !== space.id) $("wish").replaceChildren();
  rows = doc.wishes[space.id]; change = act; room = space.id;
  $("wish-room").textContent = t("Wishes for {room}", { room: space.name });
  fill("wish-list", rows, (one, k) => make("li", {}, told(one), " ", make("button", { textContent: "×", title: t("Remove"), ariaLabel: t("Remove"), onclick: () => put(rows.filter((_, n) => n !== k)) })));
  if (!$("wish").children.length) await makeForm();
}

const told = (one) => Object.entries(one).map(([key, value]) => value === true ? WORDS[key] ?? key : key === "what" ? String(value).replaceAll("_", " ") : `${WORDS[key] ?? key} ${value}`).join(" · ");
const put = (wishes) => change("wish", { space: room, wishes });
const kinds = (one) => one.anyOf?.find((each) => each.type !== "null") ?? one;

async function makeForm() {
  schema ??= await read("/wish.schema.json");
  const fields = Object.entries(schema.properties).map(([key, given]) => {
    const one = kinds(given), choices = one.enum ?? (one.$ref && schema.$defs[one.$ref.split("/").at(-1)]?.enum);
    const input = choices ? make("select", {}, new Option("–", ""), ...choices.map((value) => new Option(value, value)))
      : make("input", { type: { boolean: "checkbox", number: "number", integer: "number" }[one.type] ?? "text", step: "any" });
    input.name = key; input.required = (schema.required ?? []).includes(key);
    if (key === "what") input.setAttribute("list", "kinds");
    return make("label", {}, `${WORDS[key] ?? key.replaceAll("_", " ")} `, input);
  });
  $("wish").replaceChildren(...fields, make("button", { textContent: t("Wish for it") }));
  const shelf = await read("/shelf");
  $("kinds").replaceChildren(...[...new Set(shelf.map((row) => row.category))].sort().map((name) => new Option(name.replaceAll("_", " "), name)));
}

$("wish").onsubmit = async (event) => {
  event.preventDefault();
  const wish = {};
  for (const field of $("wish").elements) {
    if (!field.name) continue;
    const value = field.type === "checkbox" ? field.checked || undefined : field.type === "number" ? (field.value === "" ? undefined : Number(field.value)) : field.value.trim() || undefined;
    if (value !== undefined) wish[field.name] = value;
  }
  const said = await put([...rows, wish]);
  if (!said.fault) $("wish").reset();
};
