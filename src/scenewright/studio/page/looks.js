// Photographs from where one stands, and the styles and materials of a home.
import { $, make, read, say, send } from "/wire.js";
import { t } from "/words.js";

const EYE = 1.6, WIDEST = 1280;
let taking = false;

// The button is there while one walks; pressed again it gives the photograph up.
export function offerPhoto(walking, walls) {
  $("photo").hidden = $("hour").hidden = !walking || !walls;
}

export async function takePhoto([x, y, heading], floor) {
  if (taking) { await send("stop"); return; }
  const { clientWidth: wide, clientHeight: tall } = $("space"), share = Math.min(1, WIDEST / wide), size = [wide, tall].map((side) => Math.round(side * share));
  const said = await send("photo", { eye: [x, y, floor + EYE], heading, hour: $("hour").value, size });
  if (!said.fault) say(t("the light is followed …"));
}

export function notePhoto(share) {
  taking = share !== null && share < 1;
  $("photo").textContent = taking ? t("Stop the photo: {percent} %", { percent: Math.round(100 * share) }) : t("Photo");
  if (share !== 1) return;
  say("");
  const address = `/photo.png?at=${Date.now()}`;
  $("image").src = $("keep-picture").href = address;
  if (!$("shown").open) $("shown").showModal();
}

// All palettes of all styles, by their names and colours.
export async function openLooks(change) {
  const looks = await read("/looks");
  const choice = (style, [palette, colours]) => make("button", { title: t("{palette}, {style}", { palette, style }), onclick: () => { $("wardrobe").close(); change("restyle", { style, palette }); } },
    make("span", { className: "swatch" }, ...colours.map((colour) => { const bar = make("i"); bar.style.background = colour; return bar; })), palette);
  $("looks").replaceChildren(...Object.entries(looks).map(([style, palettes]) => make("section", {}, make("h2", { textContent: style }),
    make("p", { className: "palettes" }, ...Object.entries(palettes).map((one) => choice(style, one))))));
  $("wardrobe").showModal();
}

$("wardrobe-close").onclick = () => $("wardrobe").close();
