//! Where a shaft is cut: its pieces split at positions and rests.

use super::held::{RunningSum, Shaft, ShaftError};
use crate::element::BeamPiece;
use crate::solve::plane::Link;

/// Where a shaft is cut.
pub(super) struct Cuts {
    /// From cut to cut.
    pub links: Vec<Link>,
    /// The cut of each position.
    pub positions: Vec<u32>,
    /// The cut of each rest.
    pub rests: Vec<u32>,
}

/// Walks along the pieces and makes links from cut to cut.
struct Cutter<'a> {
    pieces: std::iter::Peekable<std::slice::Iter<'a, BeamPiece>>,
    links: Vec<Link>,
    /// Place of the walk, and end of the current piece.
    here: f64,
    piece_end: RunningSum,
    /// Lengths below this are no length.
    nil: f64,
}

impl<'a> Cutter<'a> {
    fn new(pieces: &'a [BeamPiece], capacity: usize, length: f64) -> Self {
        let mut pieces = pieces.iter().peekable();
        let mut piece_end = RunningSum::default();
        piece_end.add(pieces.peek().map_or(0.0, |p| p.length));
        Self { pieces, links: Vec::with_capacity(capacity), here: 0.0, piece_end, nil: 1e-13 * length }
    }

    /// Walks to `to`, and gives the number of the cut there.
    fn advance(&mut self, to: f64) -> u32 {
        while let Some(piece) = self.pieces.peek().copied() {
            let piece_end = self.piece_end.value();
            let end = to.min(piece_end);
            if end - self.here > self.nil {
                self.links.push(BeamPiece { length: end - self.here, ..*piece }.into());
                self.here = end;
            }
            if to < piece_end + self.nil {
                break;
            }
            self.pieces.next();
            match self.pieces.peek() {
                Some(next) => self.piece_end.add(next.length),
                None => break,
            }
        }
        self.links.len() as u32
    }

    /// Puts a rest under the cut that was reached.
    fn support(&mut self, stiffness: f64) {
        if let Some(link) = self.links.last_mut() {
            link.rest += stiffness;
        }
    }
}

impl Shaft {
    /// Splits the pieces at positions and rests.
    pub(super) fn cut(&self, positions: &[f64]) -> Result<Cuts, ShaftError> {
        let length = self.length();
        let on_shaft = |at: f64| match (-1e-12 * length..=length * (1.0 + 1e-12)).contains(&at) {
            true => Ok(()),
            false => Err(ShaftError::OffTheShaft { at, length }),
        };
        positions.iter().copied().chain(self.rests.iter().map(|r| r.at)).try_for_each(on_shaft)?;
        let mut order: Vec<u32> = (0..(positions.len() + self.rests.len()) as u32).collect();
        let at =
            |i: u32| positions.get(i as usize).copied().unwrap_or_else(|| self.rests[i as usize - positions.len()].at);
        if !order.is_sorted_by(|a, b| at(*a) <= at(*b)) {
            order.sort_unstable_by(|a, b| at(*a).total_cmp(&at(*b)));
        }
        let mut cutter = Cutter::new(&self.pieces, self.pieces.len() + order.len(), length);
        let (mut cuts, mut rests) = (vec![0; positions.len()], vec![0; self.rests.len()]);
        for i in order {
            let cut = cutter.advance(at(i));
            match cuts.get_mut(i as usize) {
                Some(place) => *place = cut,
                None => {
                    let rest = i as usize - positions.len();
                    cutter.support(self.rests[rest].stiffness);
                    rests[rest] = cut;
                }
            }
        }
        cutter.advance(length);
        Ok(Cuts { links: cutter.links, positions: cuts, rests })
    }
}
