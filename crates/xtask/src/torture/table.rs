//! Figures as Markdown. A program prints one JSON object a line, whose keys head the columns, or closes with a line of its
//! own that says how many actions there were.

use crate::run;
use serde_json::Value;
use std::time::Duration;

/// A table under its title, with how much was done in which time.
pub fn of(title: &str, amount: u64, took: Duration, success: bool, output: &str) -> String {
    let rows: Vec<(&str, Value)> = output.lines().filter_map(|line| Some((line, object(line)?))).collect();
    let end = if success { "nothing found" } else { "something found" };
    let asked = format!("### {title}\n\n{} asked for, {}, {end}.\n", grouped(amount), run::elapsed(took));
    let Some((line, first)) = rows.first() else {
        let closing = output.lines().rev().find(|line| line.contains(" actions"));
        return closing.map_or_else(|| asked.clone(), |line| format!("{asked}\n`{}`\n", line.trim()));
    };
    let mut keys: Vec<&String> = first.as_object().into_iter().flat_map(|first| first.keys()).collect();
    // As the program wrote them, not as they sort.
    keys.sort_by_key(|key| line.find(&format!("\"{key}\"")));
    let heads: Vec<String> = keys.iter().map(|key| key.replace('_', " ")).collect();
    let rules: Vec<&str> =
        keys.iter().map(|key| if first[key.as_str()].is_number() { "---:" } else { "---" }).collect();
    let cells = |row: &Value| keys.iter().map(|key| cell(&row[key.as_str()])).collect::<Vec<_>>();
    let lines = [heads, rules.iter().map(ToString::to_string).collect()]
        .into_iter()
        .chain(rows.iter().map(|(_, row)| cells(row)));
    let lines: Vec<String> = lines.map(|cells| format!("| {} |", cells.join(" | "))).collect();
    format!("{asked}\n{}\n", lines.join("\n"))
}

fn object(line: &str) -> Option<Value> {
    serde_json::from_str(line).ok().filter(Value::is_object)
}

/// A number with its thousands apart.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> = digits.as_bytes().rchunks(3).rev().filter_map(|group| str::from_utf8(group).ok()).collect();
    groups.join(" ")
}

fn cell(value: &Value) -> String {
    match (value.as_u64(), value.as_f64(), value.as_str()) {
        (Some(whole), ..) => grouped(whole),
        (None, Some(number), _) => {
            let digits = if number < 10.0 { 2 } else { usize::from(number < 100.0) };
            format!("{number:.digits$}")
        }
        (None, None, Some(text)) => text.to_owned(),
        _ => "–".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_object_becomes_a_row_and_other_lines_are_passed_over() {
        let output = "Compiling\n{\"kind\": \"png\", \"most_mb\": 4.256, \"inputs\": 3000000}\n7\n\
                      {\"kind\": \"icc\", \"most_mb\": 12.04, \"inputs\": 12}\n";
        let table = of("Bytes", 3_000_012, Duration::from_secs(61), true, output);
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[..3], ["### Bytes", "", "3 000 012 asked for, 61 s, nothing found."]);
        assert_eq!(lines[4..6], ["| kind | most mb | inputs |", "| --- | ---: | ---: |"]);
        assert_eq!(lines[6..], ["| png | 4.26 | 3 000 000 |", "| icc | 12.0 | 12 |"]);
    }

    #[test]
    fn a_program_without_objects_has_its_closing_line() {
        let output = "1. a click\nrestless: 20000 actions in 812 s, 0 findings\n\n";
        let table = of("Page", 20_000, Duration::from_secs(900), true, output);
        assert_eq!(table.lines().last(), Some("`restless: 20000 actions in 812 s, 0 findings`"));
    }

    #[test]
    fn a_program_without_figures_still_has_a_line() {
        let table = of("Page", 20_000, Duration::from_secs(5), false, "✗ an error\n");
        assert_eq!(table, "### Page\n\n20 000 asked for, 5.0 s, something found.\n");
    }
}
