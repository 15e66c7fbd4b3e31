import { execFileSync } from "node:child_process";

/** An option or argument, indented by two or six blanks; what it is for is indented by ten. */
const NAMED = /^ {2,6}(?=[-<\w])(.*)$/;
const EXPLAINED = /^ {10}(.*)$/;
const SECTION = /^([^\s<].*?):$/;
/** A possible value and what it means. */
const VALUE = /^- ([^:]+):\s*(.*)$/;
/** An exit code, or a command of the program's list. */
const LISTED = /^ {2}(\S+) {2,}(.*)$/;

/**
 * What the program says of itself as Markdown: its commands, and each one's help.
 *
 * @param {string} program
 */
export function commandLine(program) {
  const overview = helpOf(program, []);
  const commands = [...overview.matchAll(/^ {2}([a-z]+) {2,}/gm)].map(([, name]) => name ?? "");
  const each = commands.filter((name) => name !== "help").map((name) => `## rosto ${name}\n\n${helpAsMarkdown(helpOf(program, [name]))}`);
  const intro = "What `rosto --help`, and `--help` after each command, say.";
  return `# Command line\n\n${intro}\n\n${helpAsMarkdown(overview)}\n\n${each.join("\n\n")}\n`;
}

/**
 * A program's help as Markdown: sections as headings, options as a list.
 *
 * @param {string} help
 */
export function helpAsMarkdown(help) {
  return help.split("\n").flatMap(lineAsMarkdown).join("\n").replaceAll(/\n{3,}/g, "\n\n").trim();
}

/** @param {string} line @returns {string[]} */
function lineAsMarkdown(line) {
  const usage = /^Usage: (.*)$/.exec(line);
  if (usage) return ["", "```text", usage[1] ?? "", "```", ""];
  const section = SECTION.exec(line);
  if (section) return ["", `**${section[1]}**`, ""];
  const explained = EXPLAINED.exec(line)?.[1];
  if (explained !== undefined) return [explanation(explained)];
  const [, term, meaning] = LISTED.exec(line) ?? [];
  if (term && !term.startsWith("-")) return [`- \`${term}\` ${escaped(meaning ?? "")}`];
  const named = NAMED.exec(line)?.[1];
  if (named) return ["", `- \`${named.trim()}\``, ""];
  return [escaped(line.trim())];
}

/** @param {string} text within an option */
function explanation(text) {
  const [, value, meaning] = VALUE.exec(text) ?? [];
  if (value) return `  - \`${value}\` ${escaped(meaning ?? "")}`;
  return text.trim() && `  ${escaped(text)}`;
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll(/[<*_[\]$\\]/g, "\\$&");
}

/** @param {string} program @param {string[]} words */
function helpOf(program, words) {
  return execFileSync(program, [...words, "--help"], { encoding: "utf8" });
}
