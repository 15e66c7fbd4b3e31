/**
 * A record of docs/benchmarks.json.
 *
 * @typedef {{ task: string, what: string, size: string | null, peer: string, value: number, unit: string, samples: number, machine: string }} Record
 */

/** All records as a Markdown section with one table. @param {Record[]} records */
export function measurementsAsMarkdown(records) {
  const own = new Map(records.filter(({ peer }) => peer === "rosto").map((record) => [subject(record), record.value]));
  const rows = records.map((record) => [
    subject(record),
    record.peer,
    `${record.value} ${record.unit}`,
    `${(record.value / (own.get(subject(record)) ?? Number.NaN)).toFixed(2)} ×`,
    record.samples,
  ]);
  const lines = [["measurement", "program", "median", "ratio to Rosto", "samples"], ["---", "---", "---:", "---:", "---:"], ...rows];
  return `\n## All figures\n\n${lines.map((cells) => `| ${cells.join(" | ")} |`).join("\n")}\n`;
}

/** @param {Record} record */
function subject({ task, what, size }) {
  return [`${task}: ${what}`, size].filter(Boolean).join(", ");
}
