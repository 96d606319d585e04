//! Which weld tolerance stands out: in words, and as a drawing.

use std::fmt::Write;

use meshmend::passes::{Advice, Tolerance};
use meshmend::report::{AdviceDocument, short};

use super::step_plot::escaped;
use super::{Style, paragraph};

/// The size of the drawing, in user units, and what is round it.
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 70.0;
const TOP: f64 = 60.0;

/// What stands out, in a sentence.
pub(crate) fn advised(advice: &Advice) -> String {
    match advice.tolerance {
        Some(tolerance) => {
            let Tolerance { distance, relative, closes, .. } = tolerance;
            let [distance, percent] = [distance, three_digits(relative * 100.0)].map(short);
            let open = advice.open_edges;
            format!(
                "weld within {distance} ({percent} % of the diagonal): closes {closes} of {open} boundary edges"
            )
        }
        None if advice.open_edges == 0 => "no edge is open: weld exactly".to_owned(),
        None => "no tolerance stands out: weld exactly".to_owned(),
    }
}

fn three_digits(number: f64) -> f64 {
    format!("{number:.2e}").parse().unwrap_or(number)
}

/// The advice on a file.
pub(crate) fn advice(document: &AdviceDocument, style: Style) -> String {
    let advice = &document.advice;
    let mut page = format!("{}: {}\n", super::printable(&document.file), advised(advice));
    page.push_str(&paragraph(&style.heading("what was seen"), seen(advice)));
    let joined =
        |bin: &meshmend::passes::Bin| format!("{:>9.2e} to {:.2e}: {}", bin.from, bin.to, bin.joined);
    let heading = "vertices that would be joined, by distance";
    page.push_str(&paragraph(
        &style.heading(heading),
        advice.histogram.iter().map(joined).collect::<Vec<_>>(),
    ));
    if let Some(option) = &document.option {
        page.push_str(&paragraph(&style.heading("to weld so"), vec![format!("repair --weld {option}")]));
    }
    page
}

fn seen(advice: &Advice) -> Vec<String> {
    let mut lines = vec![format!("boundary edges where equal positions are one: {}", advice.open_edges)];
    if advice.coincident > 0 {
        lines.push(format!("of these at the place of another already: {}", advice.coincident));
    }
    if let Some(tolerance) = advice.tolerance {
        let next = match tolerance.next {
            Some(next) => format!("the next vertices are {next:.3e} apart"),
            None => "no vertices are farther apart and looked at".to_owned(),
        };
        lines.push(format!(
            "faces that vanish: 0; nothing is joined between {:.3e} and {:.3e}; {next}",
            tolerance.plateau[0], tolerance.plateau[1]
        ));
    }
    lines.push(match advice.harm {
        Some(harm) => format!("from {harm:.3e} on a face would lose a corner, or an edge its length"),
        None => format!(
            "no face would lose a corner within {:.3e}, up to where pairs were looked at",
            advice.looked_up_to
        ),
    });
    lines
}

/// The histogram and the closed edges over the distance, as SVG.
pub(crate) fn advice_plot(document: &AdviceDocument) -> String {
    let advice = &document.advice;
    let (width, height) = (LEFT + WIDTH + 70.0, TOP + HEIGHT + 60.0);
    let bottom = TOP + HEIGHT;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"{LEFT}\" y=\"24\" font-size=\"15\">{}: {}</text>\n",
        escaped(&document.file),
        escaped(&advised(advice)),
    );
    let Some(axis) = Axis::of(advice) else {
        svg.push_str("</svg>\n");
        return svg;
    };
    // Writing to a text can't fail.
    if let Some(tolerance) = advice.tolerance {
        let [from, to] = tolerance.plateau.map(|distance| axis.x(distance));
        let at = axis.x(tolerance.distance);
        let _ = write!(
            svg,
            "<rect x=\"{from:.2}\" y=\"{TOP}\" width=\"{:.2}\" height=\"{HEIGHT}\" fill=\"#e6f2e6\"/>\n\
             <path d=\"M{at:.2} {TOP}V{bottom}\" stroke=\"#3a7d44\" stroke-dasharray=\"4 3\"/>\n",
            to - from,
        );
    }
    let most = advice.histogram.iter().map(|bin| bin.joined).max().unwrap_or(1).max(1) as f64;
    for bin in &advice.histogram {
        let (from, to, high) = (axis.x(bin.from), axis.x(bin.to), bin.joined as f64 / most * HEIGHT);
        let _ = writeln!(
            svg,
            "<rect x=\"{from:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{high:.2}\" fill=\"#9fc0d8\"/>",
            bottom - high,
            to - from
        );
    }
    let scale = HEIGHT / advice.open_edges.max(1) as f64;
    let y = |closed: u64| bottom - closed as f64 * scale;
    let mut path = format!("M{LEFT} {:.2}", y(advice.coincident));
    for &(distance, closed) in &advice.closed {
        let _ = write!(path, "H{:.2}V{:.2}", axis.x(distance), y(closed));
    }
    let _ = write!(path, "H{:.2}", axis.x(advice.harm.unwrap_or(advice.looked_up_to)));
    let right = LEFT + WIDTH;
    let _ = write!(
        svg,
        "<path d=\"{path}\" fill=\"none\" stroke=\"#b3541e\" stroke-width=\"1.5\"/>\n\
         <path d=\"M{LEFT} {TOP}V{bottom}H{right}V{TOP}\" fill=\"none\" stroke=\"#888\"/>\n\
         <text x=\"{LEFT}\" y=\"{:.0}\" fill=\"#1b6ca8\">vertices joined ({most} at most)</text>\n\
         <text x=\"{right}\" y=\"{:.0}\" text-anchor=\"end\" fill=\"#b3541e\">boundary edges closed (of {})</text>\n",
        TOP - 10.0,
        TOP - 10.0,
        advice.open_edges,
    );
    for decade in axis.decades() {
        let x = axis.x(10f64.powi(decade));
        let _ = writeln!(
            svg,
            "<text x=\"{x:.2}\" y=\"{:.0}\" text-anchor=\"middle\">1e{decade}</text>",
            bottom + 20.0
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// Distances by their logarithms.
struct Axis {
    from: f64,
    to: f64,
}

impl Axis {
    /// From the first step to where looking ended; `None` if nothing would be joined.
    fn of(advice: &Advice) -> Option<Self> {
        let from = advice.histogram.first()?.from.log10();
        let to = advice.harm.unwrap_or(advice.looked_up_to).log10().max(from + 0.1);
        Some(Axis { from, to })
    }

    fn x(&self, distance: f64) -> f64 {
        LEFT + ((distance.log10() - self.from) / (self.to - self.from)).clamp(0.0, 1.0) * WIDTH
    }

    /// The powers of ten between the ends; of very many some.
    fn decades(&self) -> impl Iterator<Item = i32> {
        let (from, to) = (self.from.ceil() as i32, self.to.floor() as i32);
        (from..=to).step_by(((to - from).max(0) as usize / 16) + 1)
    }
}
