import { isWord, t } from "../words/words.ts";
import type { Control, Phrase, Widget } from "../../wasm/rosto-studio-web.js";
import { enableAction, make, makeIcon, onAction, type Root } from "../page/dom.ts";
import { textOf } from "./phrase.ts";
import { SliderView } from "./slider.ts";
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
    view.show(widget, withChildren);
  }

  #make(widget: Widget): View {
    const { control, id } = widget;
    switch (control.kind) {
      case "group":
        return this.#makeGroup(id, control);
      case "slider":
        return new SliderView(id, control, this.#send);
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

  #makeGroup(id: string, { look, tab, isOpen }: Of<"group">): View {
    const { element, body, title } = GROUPS[look](id);
    element.id = domId(id);
    if (tab) Object.assign(element.dataset, { tab, needsFace: "" });
    if (element instanceof HTMLDetailsElement) element.open = isOpen;
    return {
      element,
      show: (widget, withChildren) => {
        title(labelOf(widget));
        if (element instanceof HTMLFieldSetElement) element.disabled = !widget.isEnabled;
        if (withChildren) this.#fill(body, (widget.control as Of<"group">).widgets);
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

type Group = { element: HTMLElement; body: HTMLElement; title: (text: string) => void };

const GROUPS: Record<Of<"group">["look"], (id: string) => Group> = {
  section: () => makeFold("section", "h2", "section-body"),
  fold: () => makeFold("more", "h3", "more-body"),
  plain: () => {
    const [element, heading, body] = [make("section", "section"), make("h2", "visually-hidden"), make("div", "section-body")];
    element.append(heading, body);
    return { element, body, title: (text) => (heading.textContent = text) };
  },
  stack: () => makeFieldset("stack", "visually-hidden"),
  titled: () => makeFieldset("stack", "field-label"),
  lines: () => makeFieldset("stack lines", "visually-hidden"),
  row: () => {
    const element = make("div", "row");
    element.role = "group";
    return { element, body: element, title: (text) => (element.ariaLabel = text) };
  },
};

function makeFold(className: string, heading: "h2" | "h3", bodyClass: string): Group {
  const [element, summary, title, body] = [make("details", className), make("summary"), make(heading), make("div", bodyClass)];
  summary.append(title, makeIcon("fold"));
  element.append(summary, body);
  return { element, body, title: (text) => (title.textContent = text) };
}

function makeFieldset(className: string, legendClass: string): Group {
  const [element, legend] = [make("fieldset", className), make("legend", legendClass)];
  element.append(legend);
  return { element, body: element, title: (text) => (legend.textContent = text) };
}

function makeCheck(id: string, send: Send): View {
  const [element, input, name, notes] = [make("label", "check"), make("input"), make("span", "check-label"), make("span", "check-notes")];
  input.type = "checkbox";
  input.id = domId(id);
  input.addEventListener("change", () => send({ set: [id, input.checked] }));
  element.append(input, name, notes);
  return {
    element,
    show: (widget) => {
      const control = widget.control as Of<"check">;
      [input.checked, input.disabled, name.textContent] = [control.on, !widget.isEnabled, labelOf(widget)];
      notes.replaceChildren(...control.notes.map((note) => make("span", "caption", textOf(note))));
    },
  };
}

function makeList(id: string, send: Send): View {
  const [element, label, select, help] = [make("div"), make("label", "field-label"), make("select", "select"), make("p", "caption")];
  [select.id, label.htmlFor, help.id] = [domId(id), domId(id), `${domId(id)}-help`];
  select.setAttribute("aria-describedby", help.id);
  select.addEventListener("change", () => send({ set: [id, select.value] }));
  element.append(label, select, help);
  return {
    element,
    show: (widget) => {
      const control = widget.control as Of<"choice">;
      label.textContent = labelOf(widget);
      const none = new Option(wordOr(`${control.name}.none`, ""), "");
      none.hidden = true;
      const options = control.options.map((option) => new Option(optionName(control, option), option));
      select.replaceChildren(...(control.chosen === undefined ? [none] : []), ...options);
      [select.value, select.disabled] = [control.chosen ?? "", !widget.isEnabled];
      explain(help, control);
    },
  };
}

function makeSegments(id: string, { look, name, options, expert }: Of<"choice">, send: Send): View {
  const [element, legend, segments, help] = [make("fieldset", "choice"), make("legend", "field-label"), make("div", `choice-options ${look}`), make("p", "caption")];
  const scale = make("div", "legend");
  const scaleText = make("p", "caption");
  scale.append(make("span", "legend-bar"), scaleText);
  [element.id, help.id] = [domId(id), `${domId(id)}-help`];
  // Shown while the settings match none of a choice's presets.
  const custom = isWord(`${name}.custom`) ? ["custom"] : [];
  const inputs = [...options, ...custom].map((option) => {
    const [label, input, text] = [make("label"), make("input"), make("span")];
    Object.assign(input, { type: "radio", name: domId(id), value: option, disabled: custom.includes(option) });
    input.addEventListener("change", () => send({ set: [id, option] }));
    label.toggleAttribute("data-expert", expert.includes(option));
    label.append(input, text);
    segments.append(label);
    return { label, input, text, option };
  });
  element.append(legend, segments, help, scale);
  return {
    element,
    show: (widget) => {
      const control = widget.control as Of<"choice">;
      const chosen = control.chosen ?? "custom";
      [legend.textContent, element.disabled] = [labelOf(widget), !widget.isEnabled];
      for (const { label, input, text, option } of inputs) {
        [input.checked, text.textContent] = [option === chosen, optionName(control, option)];
        if (custom.includes(option)) label.hidden = option !== chosen;
      }
      explain(help, { ...control, chosen });
      scaleText.textContent = wordOr(`${name}.${chosen}.legend`, "");
      [scale.hidden, scale.dataset["legend"]] = [scaleText.textContent === "", chosen];
    },
  };
}

function optionName({ name }: Of<"choice">, option: string) {
  return textOf({ key: `${name}.${option}`, values: [] });
}

/** Writes the help of the chosen value, if there is one. */
function explain(help: HTMLElement, { name, chosen }: Of<"choice">) {
  help.textContent = wordOr(`${name}.${chosen}.help`, "");
  help.hidden = help.textContent === "";
}

function wordOr(key: string, otherwise: string) {
  return isWord(key) ? t(key) : otherwise;
}

function makeColour(id: string, send: Send): View {
  const [element, input, name] = [make("label", "check"), make("input"), make("span")];
  [input.type, input.id] = ["color", domId(id)];
  input.addEventListener("input", () => {
    const value = Number.parseInt(input.value.slice(1), 16);
    send({ set: [id, [(value >> 16) & 255, (value >> 8) & 255, value & 255]] });
  });
  element.append(input, name);
  return {
    element,
    show: (widget) => {
      const { rgb } = widget.control as Of<"colour">;
      [input.value, input.disabled] = [`#${rgb.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`, !widget.isEnabled];
      name.textContent = labelOf(widget);
    },
  };
}

/** Other buttons of the page with the same action, such as the toolbar's, work and are enabled like it. */
function makeButton(id: string, { isOfPage }: Of<"button">, send: Send, root: Root): View {
  const element = make("button", "button small");
  [element.type, element.id, element.dataset["action"]] = ["button", domId(id), id];
  if (!isOfPage) onAction(id, () => send({ push: id }), root);
  return {
    element,
    show: (widget) => {
      element.textContent = labelOf(widget);
      const long = `${widget.label?.key ?? id}.long`;
      if (isWord(long)) [element.ariaLabel, element.title] = [t(long), t(long)];
      element.disabled = !widget.isEnabled;
      enableAction(id, widget.isEnabled, root);
    },
  };
}

function makeText(id: string): View {
  const element = make("p", "caption");
  element.id = domId(id);
  return {
    element,
    show: (widget) => {
      const { phrase, tone } = widget.control as Of<"text">;
      const text = phrase ? textOf(phrase) : "";
      if (element.textContent !== text) element.textContent = text;
      element.hidden ||= text === "";
      element.classList.toggle("field-error", tone === "error");
      element.dataset["tone"] = tone;
      if (tone === "status") element.role = "status";
    },
  };
}

function makeFacts(id: string): View {
  const element = make("dl", "measures");
  element.id = domId(id);
  return {
    element,
    show: (widget) => {
      element.toggleAttribute("data-stale", !widget.isEnabled);
      const cells = ([name, value]: [Phrase, Phrase]) => [make("dt", "", textOf(name)), make("dd", "", textOf(value))];
      element.replaceChildren(...(widget.control as Of<"facts">).rows.flatMap(cells));
    },
  };
}

/** The element of the page that belongs there. */
function makeSlot(id: string, root: Root): View {
  const element = root.querySelector<HTMLElement>(`[data-slot="${id}"]`) ?? make("div");
  return { element, show: () => {} };
}
