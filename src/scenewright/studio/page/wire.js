// What every part of the page uses: elements, notes, and the server's verbs.
import { t } from "/words.js";

export const $ = (id) => document.getElementById(id);

export function say(text) {
  $("note").textContent = text;
  clearTimeout(say.timer);
  if (text) say.timer = setTimeout(() => { $("note").textContent = ""; }, 7000);
}

export async function send(verb, keys = {}, words = (text) => text) {
  const reply = await fetch("/do", { method: "POST", body: JSON.stringify({ verb, ...keys }) });
  const said = await reply.json().catch(() => ({ fault: t("the studio answered {status}", { status: reply.status }) }));
  if (said.fault) say(words(said.fault));
  return said;
}

export const read = async (address) => (await fetch(address)).json();

export function fill(id, rows, make) { $(id).replaceChildren(...rows.map(make)); }

export function make(name, properties = {}, ...inside) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...inside);
  return made;
}
