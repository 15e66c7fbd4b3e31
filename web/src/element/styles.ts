/** Style sheet of the element. A page can override its size, and its colours by the custom properties below. */
export const STYLES = `
:host {
  --text: var(--rosto-text, light-dark(#26241f, #ece9e3));
  --surface: var(--rosto-surface, light-dark(#fbfaf7, #202124));
  --line: var(--rosto-line, light-dark(#dcd7cc, #35363b));
  --accent: var(--rosto-accent, light-dark(#b8492f, #e07a5f));
  display: block; height: 480px; contain: content;
  font: 400 14px/20px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif; color: var(--text);
}
:host([hidden]), [hidden] { display: none !important; }
* { box-sizing: border-box; margin: 0; }
.stage { position: relative; width: 100%; height: 100%; overflow: hidden; background: light-dark(#f5f3ef, #1c1d20); }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; touch-action: none; cursor: grab; outline-offset: -4px; visibility: hidden; }
canvas:active { cursor: grabbing; }
canvas.over-landmark { cursor: move; }
::slotted(img) { position: absolute; inset: 0; width: 100%; height: 100%; object-fit: contain; }
.stage[data-state="face"] canvas { visibility: visible; }
.stage[data-state="face"] slot { visibility: hidden; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }

.tag, .progress, .notice, .toolbar { position: absolute; background: var(--surface); border: 1px solid var(--line); }
.tag { left: 0; top: 0; padding: 2px 8px; font-size: 12px; line-height: 16px; border-radius: 6px; pointer-events: none; white-space: nowrap; }
.progress, .notice, .toolbar { left: 50%; bottom: 16px; transform: translateX(-50%); border-radius: 12px; box-shadow: 0 1px 2px rgb(0 0 0 / .08), 0 8px 24px rgb(0 0 0 / .10); }
.notice { bottom: auto; top: 16px; }
.progress:not([hidden]) ~ .toolbar { visibility: hidden; }
.progress { display: grid; gap: 8px; width: min(280px, calc(100% - 32px)); padding: 12px 16px; }
progress { width: 100%; height: 4px; accent-color: var(--accent); }
.notice { width: min(400px, calc(100% - 32px)); padding: 12px 16px; border-left: 4px solid var(--accent); border-radius: 8px; overflow-wrap: anywhere; }
.toolbar { display: flex; gap: 4px; padding: 4px; }
button { width: 40px; height: 40px; display: grid; place-items: center; padding: 0; color: inherit; background: none; border: 0; border-radius: 8px; cursor: pointer; }
button:hover:enabled { background: color-mix(in oklab, transparent, var(--text) 8%); }
button:disabled { opacity: .4; cursor: default; }
svg { width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.5; stroke-linecap: round; stroke-linejoin: round; }
`;
