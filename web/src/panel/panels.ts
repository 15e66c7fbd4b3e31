import { isWord, t } from "../words/words.ts";
import type { Control, Widget } from "../../wasm/rosto-studio-web.js";
import { enableAction, make, makeIcon, onAction, type Root } from "../page/dom.ts";
import { textOf } from "./phrase.ts";
import { makeSlider } from "./slider.ts";
import { domId, labelOf, type Send, type View } from "./widget.ts";

type Of<K extends Control["kind"]> = Extract<Control, { kind: K }>;

/** Renders panels from their descriptions. */
export class Panels {
  #views = new Map<string, { view: View; widget: Widget }>();
  #place;
  #send;
  #root;

  /**
   * @param place adds a new section to the page
   * @param root the page, or the shadow root with the panels
   */
  constructor(place: (section: HTMLElement) => void, send: Send, root: Root = document) {
    this.#place = place;
    this.#send = send;
    this.#root = root;
  }

  /** Shows widgets that have changed. */
  update(widgets: Widget[]) {
    for (const widget of widgets) {
      const isNew = !this.#views.has(widget.id);
      const element = this.#show(widget);
      if (isNew) this.#place(element);
    }
  }

  /** Shows all texts in the current language. */
  translate() {
    for (const { view, widget } of this.#views.values()) this.#showIn(view, widget, false);
  }

  /** Shows a widget; returns its element. */
  #show(widget: Widget): HTMLElement {
    const known = this.#views.get(widget.id);
    const view = known?.view ?? this.#make(widget);
    this.#views.set(widget.id, { view, widget });
    this.#showIn(view, widget);
    return view.element;
  }

  #showIn(view: View, widget: Widget, withChildren = true) {
    const { element } = view;
    element.hidden = widget.isHidden;
    element.toggleAttribute("data-expert", widget.level === "expert");
    view.show(widget, widget.control, withChildren);
  }

  #make(widget: Widget): View {
    const { control, id } = widget;
    switch (control.kind) {
      case "group":
        return this.#makeGroup(id, control);
      case "slider":
        return makeSlider(id, control, this.#send);
      case "check":
        return makeCheck(id, this.#send);
      case "choice":
        return control.look === "list" ? makeList(id, this.#send) : makeSegments(id, control, this.#send);
      case "colour":
        return makeColour(id, this.#send);
      case "button":
        return makeButton(id, control, this.#send, this.#root);
      case "text":
        return makeText(id);
      case "facts":
        return makeFacts(id);
      case "slot":
        return makeSlot(id, this.#root);
    }
  }

  #makeGroup(id: string, { look, tab, isOpen }: Of<"group">): View<Of<"group">> {
    const { element, body, title } = GROUPS[look]();
    element.id = domId(id);
    if (tab) Object.assign(element.dataset, { tab, needsFace: "" });
    if (element instanceof HTMLDetailsElement) element.open = isOpen;
    return {
      element,
      show: (widget, { widgets }, withChildren) => {
        if (title) title.textContent = labelOf(widget);
        else element.ariaLabel = labelOf(widget);
        if (element instanceof HTMLFieldSetElement) element.disabled = !widget.isEnabled;
        if (withChildren) this.#fill(body, widgets);
      },
    };
  }

  /** Puts widgets into a group; moves no element that is in its place. */
  #fill(body: HTMLElement, widgets: Widget[]) {
    const first = body.firstElementChild instanceof HTMLLegendElement ? 1 : 0;
    for (const [place, widget] of widgets.entries()) {
      const element = this.#show(widget);
      const there = body.children[first + place];
      if (there !== element) body.insertBefore(element, there ?? null);
    }
    while (body.children.length > first + widgets.length) body.lastElementChild?.remove();
  }
}

/** Choices that need no visible name. */
const QUIET = new Set(["selection", "region"]);

/** A group without a title is labelled for screen readers only. */
type Group = { element: HTMLElement; body: HTMLElement; title?: HTMLElement };

const GROUPS: Record<Of<"group">["look"], () => Group> = {
  section: () => makeFold("section", "h2", "section-body"),
  fold: () => makeFold("more", "h3", "more-body"),
  plain: () => {
    const [title, body] = [make("h2", "visually-hidden"), make("div", "section-body")];
    return { element: make("section", "section", title, body), body, title };
  },
  stack: () => makeFieldset("stack", "visually-hidden"),
  titled: () => makeFieldset("stack", "field-label"),
  lines: () => makeFieldset("stack lines", "visually-hidden"),
  chips: () => makeFieldset("chips", "visually-hidden"),
  row: () => {
    const element = make("div", "row");
    element.role = "group";
    return { element, body: element };
  },
};

function makeFold(className: string, heading: "h2" | "h3", bodyClass: string): Group {
  const [title, body] = [make(heading), make("div", bodyClass)];
  return { element: make("details", className, make("summary", "", title, makeIcon("fold")), body), body, title };
}

function makeFieldset(className: string, legendClass: string): Group {
  const title = make("legend", legendClass);
  const element = make("fieldset", className, title);
  return { element, body: element, title };
}

function makeCheck(id: string, send: Send): View<Of<"check">> {
  const [input, name, notes] = [make("input"), make("span", "check-label"), make("span", "check-notes")];
  [input.type, input.id] = ["checkbox", domId(id)];
  input.addEventListener("change", () => send({ set: [id, input.checked] }));
  return {
    element: make("label", "check", input, name, notes),
    show: (widget, control) => {
      [input.checked, input.disabled, name.textContent] = [control.on, !widget.isEnabled, labelOf(widget)];
      notes.replaceChildren(...control.notes.map((note) => make("span", "caption", textOf(note))));
    },
  };
}

function makeList(id: string, send: Send): View<Of<"choice">> {
  const [label, select, help] = [make("label", QUIET.has(id) ? "visually-hidden" : "field-label"), make("select", "select"), make("p", "caption")];
  [select.id, label.htmlFor, help.id] = [domId(id), domId(id), `${domId(id)}-help`];
  select.setAttribute("aria-describedby", help.id);
  select.addEventListener("change", () => send({ set: [id, select.value] }));
  return {
    element: make("div", "", label, select, help),
    show: (widget, { name, options, chosen }) => {
      label.textContent = labelOf(widget);
      const none = new Option(wordOr(`${name}.none`), "");
      none.hidden = true;
      const named = options.map((option) => new Option(optionName(name, option), option));
      select.replaceChildren(...(chosen === undefined ? [none] : []), ...named);
      [select.value, select.disabled] = [chosen ?? "", !widget.isEnabled];
      write(help, wordOr(`${name}.${chosen}.help`));
    },
  };
}

function makeSegments(id: string, { look, name, options, expert }: Of<"choice">, send: Send): View<Of<"choice">> {
  const [legend, segments] = [make("legend", "field-label"), make("div", `choice-options ${look}`)];
  if (look === "icons" || QUIET.has(id)) legend.className = "visually-hidden";
  const [help, scaleText] = [make("p", "caption"), make("p", "caption")];
  const scale = make("div", "legend", make("span", "legend-bar"), scaleText);
  const element = make("fieldset", "choice", legend, segments, help, scale);
  [element.id, help.id] = [domId(id), `${domId(id)}-help`];
  // Shown while the settings match none of a choice's presets.
  const custom = isWord(`${name}.custom`) ? ["custom"] : [];
  const inputs = [...options, ...custom].map((option) => {
    const [input, text] = [make("input"), make("span")];
    Object.assign(input, { type: "radio", name: domId(id), value: option, disabled: custom.includes(option) });
    input.addEventListener("change", () => send({ set: [id, option] }));
    const label = make("label", "", input, ...(look === "icons" ? [make("span", "", makeIcon(`${name}-${option}`), text)] : [text]));
    label.toggleAttribute("data-expert", expert.includes(option));
    segments.append(label);
    return { label, input, text, option };
  });
  return {
    element,
    show: (widget, { chosen = "custom" }) => {
      [legend.textContent, element.disabled] = [labelOf(widget), !widget.isEnabled];
      for (const { label, input, text, option } of inputs) {
        [input.checked, text.textContent] = [option === chosen, optionName(name, option)];
        if (custom.includes(option)) label.hidden = option !== chosen;
      }
      write(help, wordOr(`${name}.${chosen}.help`));
      write(scaleText, wordOr(`${name}.${chosen}.legend`));
      [scale.hidden, scale.dataset["legend"]] = [scaleText.hidden, chosen];
    },
  };
}

function optionName(choice: string, option: string) {
  return textOf({ key: `${choice}.${option}`, values: [] });
}

function wordOr(key: string) {
  return isWord(key) ? t(key) : "";
}

/** Shows a text, or hides its element. */
function write(element: HTMLElement, text: string) {
  // The same text again would be read again.
  if (element.textContent !== text) element.textContent = text;
  element.hidden = text === "";
}

function makeColour(id: string, send: Send): View<Of<"colour">> {
  const [input, name] = [make("input"), make("span")];
  [input.type, input.id] = ["color", domId(id)];
  input.addEventListener("input", () => {
    const value = Number.parseInt(input.value.slice(1), 16);
    send({ set: [id, [(value >> 16) & 255, (value >> 8) & 255, value & 255]] });
  });
  return {
    element: make("label", "check", input, name),
    show: (widget, { rgb }) => {
      input.value = `#${rgb.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
      [input.disabled, name.textContent] = [!widget.isEnabled, labelOf(widget)];
    },
  };
}

/** Other buttons of the page with the same action, such as the toolbar's, work and are enabled like it. */
function makeButton(id: string, { isOfPage }: Of<"button">, send: Send, root: Root): View<Of<"button">> {
  const element = make("button", "button small");
  [element.type, element.id, element.dataset["action"]] = ["button", domId(id), id];
  if (!isOfPage) onAction(id, () => send({ push: id }), root);
  return {
    element,
    show: (widget) => {
      element.textContent = labelOf(widget);
      const long = wordOr(`${widget.label?.key ?? id}.long`);
      if (long) [element.ariaLabel, element.title] = [long, long];
      element.disabled = !widget.isEnabled;
      enableAction(id, widget.isEnabled, root);
    },
  };
}

function makeText(id: string): View<Of<"text">> {
  const element = make("p", "caption");
  element.id = domId(id);
  return {
    element,
    show: (widget, { phrase, tone }) => {
      write(element, phrase ? textOf(phrase) : "");
      element.hidden ||= widget.isHidden;
      element.classList.toggle("field-error", tone === "error");
      element.dataset["tone"] = tone;
      if (["status", "busy", "warning"].includes(tone)) element.role = "status";
    },
  };
}

function makeFacts(id: string): View<Of<"facts">> {
  const element = make("dl", "measures");
  element.id = domId(id);
  return {
    element,
    show: (widget, { rows }) => {
      element.toggleAttribute("data-stale", !widget.isEnabled);
      const cells = rows.flatMap(([name, value]) => [make("dt", "", textOf(name)), make("dd", "", textOf(value))]);
      element.replaceChildren(...cells);
    },
  };
}

/** The element of the page that belongs there. */
function makeSlot(id: string, root: Root): View {
  const element = root.querySelector<HTMLElement>(`[data-slot="${id}"]`) ?? make("div");
  return { element, show: () => {} };
}
