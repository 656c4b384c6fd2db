// People: a link for each, what they may do, and what those who rate liked together.
import { drawCard, element } from "/draw.js";
import { unpack } from "/state.js";
import { $, fill, make, read, say, send } from "/wire.js";
import { t } from "/words.js";

const MAY = { rate: t("rates layouts"), edit: t("changes the plan"), view: t("looks at the plan") };
let taken = null, link = "";

export async function openPeople(done) {
  taken = done; link = "";
  if (!$("people").open) $("people").showModal();
  await refreshPeople();
  $("person-name").focus();
}

export async function refreshPeople() {
  if (!$("people").open) return;
  const told = await read("/ratings");
  fill("people-list", told.people ?? [], row);
  if (!(told.people ?? []).length) $("people-list").replaceChildren(make("li", { textContent: t("nobody yet") }));
  $("pool").textContent = told.pool ? t("{n} layouts are there to be rated", { n: told.pool }) : t("Nothing is given out to be rated yet.");
  const cards = new Map(await unpack(told));
  fill("liked", told.liked ?? [], (one) => liked(one, cards.get(one.number)));
  $("person-link").hidden = !link; $("person-link").value = link;
}

function row(one) {
  const marks = one.right === "rate" ? t("{n} marks", { n: one.marks }) : "";
  return make("li", {}, make("strong", { textContent: one.name }), ` ${MAY[one.right]} ${marks} `,
    make("button", { textContent: t("New link"), title: t("the one before lets nobody in any more"), onclick: () => act("renew", { person: one.id }) }),
    make("button", { textContent: t("Remove"), onclick: () => act("drop", { person: one.id }) }));
}

function liked(one, card) {
  const svg = element("svg", { role: "img", "aria-label": t("layout {n}", { n: one.number + 1 }) });
  drawCard(card, svg);
  const stars = one.stars === null ? "" : ` · ★ ${one.stars.toFixed(1)}`;
  return make("article", { className: "card" }, svg,
    make("div", { className: "top", textContent: t("best {best}× · worst {worst}×", one) + stars }),
    make("button", { textContent: t("Use"), title: t("take this layout to the plan"), onclick: () => use(one.number) }));
}

async function use(number) {
  const said = await send("take", { number });
  if (!said.fault) { $("people").close(); await taken?.(); }
}

async function act(verb, keys) {
  const said = await send(verb, keys);
  if (said.token) {
    link = `${location.origin}/?token=${said.token}`;
    await navigator.clipboard?.writeText(link).then(() => say(t("the link is copied: send it")), () => {});
  }
  await refreshPeople();
  if (link) $("person-link").select();
  return said;
}

$("invite").onsubmit = async (event) => {
  event.preventDefault();
  const said = await act("invite", { name: $("person-name").value, right: $("person-right").value });
  if (!said.fault) $("person-name").value = "";
};
$("give").onclick = () => act("give", {});
$("person-link").onclick = () => $("person-link").select();
$("people-close").onclick = () => $("people").close();
