//! Columns of text that stand under one another.

/// On which side of its column a cell stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Right,
}

/// The rows as lines, without the spaces at their ends. Rows may be shorter than others.
pub(super) fn lines(rows: &[Vec<String>], alignment: &[Align]) -> Vec<String> {
    let column_count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..column_count).map(width).collect();
    let cell = |column: usize, text: &String| {
        let width = widths[column];
        match alignment.get(column) {
            Some(Align::Right) => format!("{text:>width$}"),
            _ => format!("{text:<width$}"),
        }
    };
    let line = |row: &Vec<String>| {
        let cells: Vec<String> = row.iter().enumerate().map(|(column, text)| cell(column, text)).collect();
        cells.join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_under_one_another_whatever_their_letters() {
        let rows = [vec!["Möbius band", "1"], vec!["disc", "12", "x"]]
            .map(|row| row.iter().map(|c| c.to_string()).collect());
        assert_eq!(lines(&rows, &[Align::Left, Align::Right]), ["Möbius band   1", "disc         12  x"]);
    }
}
