//! Numbering of the freedoms: free ones in elimination order, held ones last.

/// The freedoms of a mesh, `components` at each node (1 temperature, 2 displacements, or 3 of waves around). Freedom
/// `components · node + component` has the number `number(freedom)` in the matrix.
#[derive(Clone, Debug)]
pub struct Freedoms {
    components: usize,
    /// Number of every freedom in the matrix.
    numbers: Vec<u32>,
    /// Freedom of every number.
    freedoms: Vec<u32>,
    free: usize,
}

impl Freedoms {
    /// Numbers the freedoms of nodes eliminated in `order`; those in `held` (freedoms) have prescribed
    /// values.
    pub fn new(components: usize, order: &[u32], held: &[usize]) -> Self {
        let count = components * order.len();
        let mut is_held = vec![false; count];
        for &freedom in held {
            is_held[freedom] = true;
        }
        let own = |&node: &u32| (0..components).map(move |component| node as usize * components + component);
        let mut freedoms: Vec<u32> =
            order.iter().flat_map(own).filter(|&freedom| !is_held[freedom]).map(|freedom| freedom as u32).collect();
        let free = freedoms.len();
        freedoms.extend((0..count).filter(|&freedom| is_held[freedom]).map(|freedom| freedom as u32));
        let numbers = super::order::ranks(&freedoms);
        Self { components, numbers, freedoms, free }
    }

    /// Freedoms at a node.
    pub fn components(&self) -> usize {
        self.components
    }

    /// Number of all freedoms.
    pub fn len(&self) -> usize {
        self.freedoms.len()
    }

    /// Whether there are no freedoms.
    pub fn is_empty(&self) -> bool {
        self.freedoms.is_empty()
    }

    /// Number of free ones: the unknowns.
    pub fn free(&self) -> usize {
        self.free
    }

    /// Place in the matrix of a freedom.
    pub fn number(&self, freedom: usize) -> usize {
        self.numbers[freedom] as usize
    }

    /// Freedom at a place of the matrix.
    pub fn freedom(&self, number: usize) -> usize {
        self.freedoms[number] as usize
    }

    /// Whether the value of a freedom is prescribed.
    pub fn is_held(&self, freedom: usize) -> bool {
        self.number(freedom) >= self.free
    }

    /// The freedoms with prescribed values, ascending.
    pub fn held(&self) -> impl Iterator<Item = usize> {
        self.freedoms[self.free..].iter().map(|&freedom| freedom as usize)
    }

    /// Values of all freedoms in the order of the matrix.
    pub fn gather(&self, values: &[f64]) -> Vec<f64> {
        self.freedoms.iter().map(|&freedom| values[freedom as usize]).collect()
    }

    /// Values in the order of the matrix put back to their freedoms.
    pub fn scatter(&self, numbered: &[f64]) -> Vec<f64> {
        self.numbers.iter().map(|&number| numbered[number as usize]).collect()
    }
}
