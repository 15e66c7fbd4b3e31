import { execFileSync } from "node:child_process";

/** An option or argument, indented by two to six spaces. */
const NAMED = /^ {2,6}(?=[-<\w])(.*)$/;
/** The explanation of an option, indented by ten spaces. */
const EXPLAINED = /^ {10}(.*)$/;
const SECTION = /^([^\s<].*?):$/;
/** A possible value and its meaning. */
const VALUE = /^- ([^:]+):\s*(.*)$/;
/** An exit code or a command, with its meaning. */
const LISTED = /^ {2}(\S+) {2,}(.*)$/;

/**
 * The program's help as Markdown: the overview, then each command.
 *
 * @param {string} program
 */
export function commandLine(program) {
  const overview = helpOf(program, []);
  const commands = [...overview.matchAll(/^ {2}([a-z]+) {2,}/gm)].map(([, name]) => name ?? "");
  const each = commands.filter((name) => name !== "help").map((name) => `## rosto ${name}\n\n${helpAsMarkdown(helpOf(program, [name]))}`);
  const intro = "Output of `rosto --help` and of `rosto COMMAND --help`.";
  return `# Command line reference\n\n${intro}\n\n${helpAsMarkdown(overview)}\n\n${each.join("\n\n")}\n`;
}

/**
 * A help text as Markdown: section titles in bold, options as a list.
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

/** A line of an option's explanation. @param {string} text */
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
