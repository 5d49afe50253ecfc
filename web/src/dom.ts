// Elements in one call.

type Content = Node | string | null | undefined | false;

export function el<K extends keyof HTMLElementTagNameMap>(
  name: K,
  attributes: Record<string, string> = {},
  ...content: Content[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  for (const part of content) if (part) element.append(part);
  return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Record<string, string | number> = {},
  text = "",
): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  if (text) element.textContent = text;
  return element;
}

export function button(text: string, help: string, act: () => void): HTMLButtonElement {
  const element = el("button", { type: "button", title: help }, text);
  element.addEventListener("click", act);
  return element;
}

/** A labelled list to choose from; `act` is told the value chosen. */
export function choice(
  label: string,
  options: [value: string, text: string][],
  chosen: string,
  act: (value: string) => void,
): HTMLLabelElement {
  const list = el("select");
  for (const [value, text] of options) list.append(el("option", { value }, text));
  list.value = chosen;
  list.addEventListener("change", () => act(list.value));
  return el("label", { class: "field" }, el("span", {}, label), list);
}

export function check(label: string, on: boolean, act: (on: boolean) => void): HTMLLabelElement {
  const box = el("input", { type: "checkbox" });
  box.checked = on;
  box.addEventListener("change", () => act(box.checked));
  return el("label", { class: "check" }, box, label);
}
