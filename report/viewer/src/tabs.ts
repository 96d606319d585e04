// Tabs: one panel is seen at a time; on paper all are.

import { h } from "./dom.js";

export interface Tab { name: string; title: string; panel: HTMLElement }

export class Tabs {
  readonly bar = h("div", { role: "tablist", class: "tabs", "aria-label": "what to read" });
  readonly panels = h("div", { class: "panels" });
  private readonly buttons = new Map<string, HTMLButtonElement>();

  constructor(private readonly tabs: Tab[]) {
    tabs.forEach(({ name, title, panel }, place) => {
      const button = h("button", {
        type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `panel-${name}`,
        click: () => this.open(name),
        keydown: (event: KeyboardEvent) => {
          const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
          if (step === 0) return;
          const seen = tabs.filter(tab => !this.buttons.get(tab.name)!.hidden);
          const next = seen[(seen.findIndex(tab => tab.name === name) + step + seen.length) % seen.length];
          this.open(next.name);
          this.buttons.get(next.name)!.focus();
        },
      }, title);
      this.buttons.set(name, button);
      this.bar.append(button);
      panel.id = `panel-${name}`;
      panel.setAttribute("role", "tabpanel");
      panel.setAttribute("aria-labelledby", `tab-${name}`);
      panel.tabIndex = 0;
      panel.dataset["title"] = title;
      this.panels.append(panel);
      if (place === 0) this.open(name);
    });
  }

  open(name: string): void {
    for (const tab of this.tabs) {
      const button = this.buttons.get(tab.name);
      button?.setAttribute("aria-selected", String(tab.name === name));
      if (button !== undefined) button.tabIndex = tab.name === name ? 0 : -1;
      tab.panel.classList.toggle("closed", tab.name !== name);
    }
  }

  hide(name: string, isHidden: boolean): void {
    const button = this.buttons.get(name);
    if (button !== undefined) button.hidden = isHidden;
    this.tabs.find(tab => tab.name === name)!.panel.hidden = isHidden;
    if (isHidden && button?.getAttribute("aria-selected") === "true") this.open(this.tabs.find(tab => tab.name !== name)!.name);
  }
}
