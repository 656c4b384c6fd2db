// The shelf: models of the catalog by pictures, to be put in or taken in exchange.
import { $, make, read } from "/wire.js";

let rows = [], take = null, category = "";

export async function openShelf(title, only, chosen) {
  rows = await read("/shelf"); category = only; take = chosen;
  $("shelf-title").textContent = title; $("shelf-search").value = "";
  show(); $("shelf").showModal(); $("shelf-search").focus();
}

function show() {
  const asked = $("shelf-search").value.trim().toLowerCase();
  const found = rows.filter((row) => asked ? `${row.kind} ${row.name}`.toLowerCase().includes(asked) : !category || row.category === category);
  $("shelf-cards").replaceChildren(...found.slice(0, 400).map((row) => {
    const [width, depth] = row.size, image = make("img", { src: `/thumb.png?asset=${encodeURIComponent(row.asset)}`, alt: "", loading: "lazy", width: 96, height: 96 });
    return make("button", { className: "model", title: row.kind, onclick: () => { $("shelf").close(); take(row); } }, image,
      make("span", { textContent: row.name }), make("small", { textContent: `${width.toFixed(2)} × ${depth.toFixed(2)} m` }));
  }));
}

$("shelf-search").oninput = show;
$("shelf-close").onclick = () => $("shelf").close();
