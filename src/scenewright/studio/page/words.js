// One table of words: English is written where it is shown, other languages are looked up by it.
const lang = document.documentElement.lang;
const table = lang === "en" ? {} : await (await fetch(`/words.${lang}.json`)).json();

export const t = (text, values = {}) => (table[text] ?? text).replace(/\{(\w+)\}/g, (_, key) => values[key] ?? "");

// What is shown, by an attribute or as text, of all that the page holds from the start.
const ATTRIBUTES = ["title", "aria-label", "placeholder", "alt"];
if (lang !== "en") {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode, text = node.nodeValue.trim().replace(/\s+/g, " ");
    if (table[text]) node.nodeValue = node.nodeValue.replace(node.nodeValue.trim(), table[text]);
  }
  for (const name of ATTRIBUTES) for (const node of document.querySelectorAll(`[${name}]`)) node.setAttribute(name, t(node.getAttribute(name)));
}

const choice = document.getElementById("language");
choice.value = lang;
choice.onchange = () => {
  document.cookie = `scenewright-language=${choice.value}; Path=/; Max-Age=31536000; SameSite=Strict`;
  location.reload();
};
