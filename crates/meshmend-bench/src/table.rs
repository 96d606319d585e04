//! Rows as a table in Markdown.

use crate::rows::Row;

/// The first two lines.
pub(crate) const HEAD: &str = "\
| operation | order | threads | faces | Mf/s | CPU s: best | median | wall s: best | median | B/f | growth |
|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|";

/// One line. A wrong answer has no time.
pub(crate) fn line(row: &Row) -> String {
    let Row { operation, order, threads, faces, .. } = row;
    let start = format!("| {operation} | {order} | {threads} | {faces} |");
    if !row.is_right() {
        return format!("{start} wrong: {:?}, not {:?} |||||||", row.figures, row.expected);
    }
    let growth = row.growth.map_or("–".to_owned(), |growth| format!("{growth:.1}"));
    format!(
        "{start} {:.2} | {:.4} | {:.4} | {:.4} | {:.4} | {:.0} | {growth} |",
        row.megafaces, row.cpu.best, row.cpu.median, row.wall.best, row.wall.median, row.bytes_a_face,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rows::tests::a_row;

    fn cells(line: &str) -> usize {
        line.matches('|').count()
    }

    #[test]
    fn every_line_has_the_cells_of_the_head() {
        let head = HEAD.lines().next().unwrap_or_default();
        let row = a_row(1_000_000, 0.125);
        assert_eq!(
            line(&row),
            "| weld | mesh | 1 | 1000000 | 8.00 | 0.1250 | 0.1875 | 0.1250 | 0.1875 | 30 | – |"
        );
        assert_eq!(cells(&line(&row)), cells(head));
        let wrong = Row { figures: [("vertices".to_owned(), 1)].into(), ..row };
        assert_eq!(cells(&line(&wrong)), cells(head));
        assert!(line(&wrong).contains("wrong") && !line(&wrong).contains("8.00"));
    }
}
