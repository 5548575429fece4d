//! The border of a mesh, whatever its sides are called.

use std::collections::{HashMap, HashSet};

use super::{Mesh, MeshError, Side};

impl Mesh {
    /// All sides that belong to one element only, in the order of the elements.
    pub fn boundary(&self) -> Vec<Side> {
        let mut counts: HashMap<(u32, u32), u32> = HashMap::new();
        let ends = |side: Side| {
            let nodes = self.side_nodes(side);
            let [a, b] = [nodes.as_slice()[0], nodes.as_slice()[1]];
            (a.min(b), a.max(b))
        };
        let sides: Vec<Side> = self
            .elements()
            .flat_map(|element| {
                (0..element.kind.edges().len() as u8).map(move |side| Side { element: element.index as u32, side })
            })
            .collect();
        for &side in &sides {
            *counts.entry(ends(side)).or_default() += 1;
        }
        sides.into_iter().filter(|&side| counts[&ends(side)] == 1).collect()
    }

    /// Calls those of the sides called `of` whose middle (m) is in some part by `name`.
    ///
    /// # Errors
    /// The mesh has no sides called `of`.
    pub fn name_part(&mut self, name: &str, of: &str, is_in: impl Fn([f64; 2]) -> bool) -> Result<(), MeshError> {
        let own = self.sides(of)?.iter().copied().filter(|side| is_in(self.curve(*side).point(0.0))).collect();
        self.sides.insert(name.to_owned(), own);
        Ok(())
    }

    /// Calls the part of the border that is on no sides called one of `others` by `name`.
    ///
    /// # Errors
    /// The mesh has no sides of one of these names.
    pub fn name_rest(&mut self, name: &str, others: &[&str]) -> Result<(), MeshError> {
        let mut taken: HashSet<Side> = HashSet::new();
        for other in others {
            taken.extend(self.sides(other)?);
        }
        let rest = self.boundary().into_iter().filter(|side| !taken.contains(side)).collect();
        self.sides.insert(name.to_owned(), rest);
        Ok(())
    }
}
