//! The matrices and the heat supply of a body.

use std::sync::Arc;

use super::conditions::{Amplitude, MovingStrip, Supply, side_shares};
use super::surface::Surface;
use super::varying::{Slopes, Varying};
use super::{Condition, History, Properties, ThermalError};
use crate::element::plane::{Capacity, Conduction, EDGE_NODES, MAX_NODES, Square, Thickness};
use crate::mesh::{Mesh, Side};
use crate::solve::sparse::{Analysis, Freedoms, Graph, Matrix, Order, Pattern};

/// Steps of Newton's method in which surfaces find their temperatures.
pub(super) const MAX_ITERATIONS: usize = 60;
/// Changes of temperatures at which they have, K: far above round-off of a thousand kelvin, far below what anybody measures.
const REST: f64 = 1e-9;

/// A body with its conditions, assembled.
pub struct ThermalSystem<'m> {
    pub(super) mesh: &'m Mesh,
    pub(super) freedoms: Freedoms,
    /// Conduction and convection, W/K.
    pub(super) conductance: Matrix,
    /// Heat capacity, J/K.
    pub(super) capacity: Matrix,
    pub(super) analysis: Analysis,
    /// Prescribed temperature of the held nodes, in the order of the matrix.
    held: Vec<History>,
    supplies: Vec<Supply>,
    strips: Vec<MovingStrip>,
    /// Convection to surroundings: K · 1 (W/K), in the order of the matrix.
    pub(super) losses: Vec<f64>,
    /// C · 1 (J/K), in the order of the matrix.
    pub(super) stores: Vec<f64>,
    pub(super) switches: Vec<f64>,
    ambients: Vec<Supply>,
    pub(super) surfaces: Vec<Surface>,
    varying: Option<Varying>,
}

impl<'m> ThermalSystem<'m> {
    /// Assembles a body of one material.
    ///
    /// # Errors
    /// A value out of range, sides or nodes that do not exist.
    pub fn new(
        mesh: &'m Mesh,
        law: Conduction,
        capacity: Capacity,
        conditions: &[Condition],
    ) -> Result<Self, ThermalError> {
        Self::over_temperature(mesh, law, None, capacity, conditions)
    }

    /// The same of a material whose `properties` change with its temperature: `law` has those at zero.
    ///
    /// # Errors
    /// A value out of range, sides or nodes that do not exist.
    pub fn over_temperature(
        mesh: &'m Mesh,
        law: Conduction,
        properties: Option<Properties>,
        capacity: Capacity,
        conditions: &[Condition],
    ) -> Result<Self, ThermalError> {
        check(&law)?;
        let (held_nodes, held) = prescribed(mesh, conditions)?;
        let graph = Graph::new(mesh);
        let order = Order::default().find(&graph, mesh.nodes())?;
        let freedoms = Freedoms::new(1, &order, &held_nodes);
        let pattern = Arc::new(Pattern::new(&graph, &freedoms));
        let mut conductance = Matrix::assemble::<1>(mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
            law.conductance(sampled, coordinates, square);
        })?;
        let capacity = Matrix::assemble::<1>(mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
            law.capacity(capacity, sampled, coordinates, square);
        })?;
        let varying = properties.map(|properties| Varying::new(properties, conductance.clone())).transpose()?;
        let mut ambients = convections(&mut conductance, mesh, &freedoms, &law, conditions)?;
        let ones = vec![1.0; freedoms.len()];
        let stores = capacity.multiply(&ones);
        for condition in conditions {
            if let (Condition::Faces { coefficient, ambient }, Thickness::Uniform(thickness)) =
                (condition, law.thickness)
            {
                check_film(*coefficient)?;
                // Both faces over the heat that the sheet between them stores.
                let factor = 2.0 * coefficient / (thickness * law.heat_capacity);
                conductance = conductance.combined(1.0, &capacity, factor);
                let shares = (0..mesh.nodes().len()).map(|node| (node, factor * stores[freedoms.number(node)]));
                ambients.push(Supply { shares: shares.collect(), amplitude: Amplitude::Varying(ambient.clone()) });
            }
        }
        let mut losses = vec![0.0; freedoms.len()];
        for &(node, share) in ambients.iter().flat_map(|ambient| &ambient.shares) {
            losses[freedoms.number(node)] += share;
        }
        let analysis = Analysis::of(&conductance)?;
        let switches = conditions.iter().flat_map(Condition::switches).collect();
        let (supplies, strips) = supplies(mesh, &law, conditions)?;
        Ok(Self {
            mesh,
            freedoms,
            conductance,
            capacity,
            analysis,
            held,
            supplies,
            strips,
            losses,
            stores,
            switches,
            ambients,
            surfaces: Surface::of(mesh, law.thickness, conditions)?,
            varying,
        })
    }

    /// Mean temperature over the body of the temperatures of all nodes, weighted by heat capacity.
    pub fn mean(&self, temperatures: &[f64]) -> f64 {
        let whole: f64 = self.stores.iter().sum();
        let weight = |(node, temperature): (usize, &f64)| self.stores[self.freedoms.number(node)] * temperature;
        temperatures.iter().enumerate().map(weight).sum::<f64>() / whole
    }

    /// Bytes held by the matrices.
    pub fn bytes(&self) -> usize {
        self.conductance.bytes() + self.capacity.bytes() + self.conductance.pattern().bytes()
    }

    /// Whether what the body loses and conducts is in proportion to its temperature.
    pub(super) fn is_linear(&self) -> bool {
        self.surfaces.is_empty() && self.varying.is_none()
    }

    /// Temperature of what has an enthalpy, K of the capacity at the start.
    pub(super) fn temperature(&self, enthalpy: f64) -> f64 {
        self.varying.as_ref().map_or(enthalpy, |varying| varying.temperature(enthalpy))
    }

    /// Enthalpy (K) of what has a temperature.
    pub(super) fn enthalpy(&self, temperature: f64) -> f64 {
        self.varying.as_ref().map_or(temperature, |varying| varying.enthalpy(temperature))
    }

    /// Temperatures of all nodes of these enthalpies (in the order of the matrix).
    pub(super) fn scattered(&self, enthalpies: &[f64]) -> Vec<f64> {
        let mut all = self.freedoms.scatter(enthalpies);
        if self.varying.is_some() {
            all.iter_mut().for_each(|own| *own = self.temperature(*own));
        }
        all
    }

    /// # Errors
    /// The body is warmer or colder at `time` than its properties are known.
    pub(super) fn check_known(&self, time: f64, enthalpies: &[f64]) -> Result<(), ThermalError> {
        self.varying.as_ref().map_or(Ok(()), |varying| varying.check(time, enthalpies))
    }

    /// Writes the enthalpies of the prescribed temperatures at `time` into `enthalpies` (in the order of the matrix).
    pub(super) fn set_held(&self, time: f64, enthalpies: &mut [f64]) {
        for (enthalpy, history) in enthalpies[self.freedoms.free()..].iter_mut().zip(&self.held) {
            *enthalpy = self.enthalpy(history.at(time));
        }
    }

    /// Adds the heat (W, in the order of the matrix) of fluxes and sources at `time` of a step. The sum.
    pub(super) fn supply(&self, time: f64, step: [f64; 2], heat: &mut [f64]) -> f64 {
        let mut sum = self.add_supplies(&self.supplies, time, step, heat);
        for strip in &self.strips {
            strip.heat(self.mesh, (time, step), |node, own| {
                heat[self.freedoms.number(node)] += own;
                sum += own;
            });
        }
        sum
    }

    /// Adds the heat (W) that convection brings from surroundings at their temperature to a body at 0, at
    /// `time` of a step. The sum.
    pub(super) fn add_ambient(&self, time: f64, step: [f64; 2], heat: &mut [f64]) -> f64 {
        self.add_supplies(&self.ambients, time, step, heat)
    }

    fn add_supplies(&self, supplies: &[Supply], time: f64, step: [f64; 2], heat: &mut [f64]) -> f64 {
        let mut sum = 0.0;
        for supply in supplies {
            let amplitude = supply.amplitude.within(time, step);
            for &(node, share) in &supply.shares {
                heat[self.freedoms.number(node)] += amplitude * share;
                sum += amplitude * share;
            }
        }
        sum
    }

    /// Takes off the heat (W) what nodes with these enthalpies (in the order of the matrix) lose by surfaces at `time` of a
    /// step, and conduct and lose otherwise than in proportion to their enthalpy. The sum of what is lost so, and the slopes
    /// of it.
    pub(super) fn lose(&self, at: (f64, [f64; 2]), enthalpies: &[f64], heat: &mut [f64]) -> (f64, Slopes) {
        let mut slopes = Slopes { surfaces: vec![0.0; enthalpies.len()], varying: None };
        let mut sum = 0.0;
        let warm = self.varying.as_ref().map(|varying| {
            let (warm, relative) = varying.lose(enthalpies, &self.conductance, heat);
            let by_film = |((loss, warm), own): ((&f64, &f64), &f64)| loss * (warm - own);
            sum += self.losses.iter().zip(&warm).zip(enthalpies).map(by_film).sum::<f64>();
            slopes.varying = Some(relative);
            warm
        });
        let warm = warm.as_deref().unwrap_or(enthalpies);
        for surface in &self.surfaces {
            surface.lose(
                at,
                |node| warm[self.freedoms.number(node)],
                |node, lost, slope| {
                    let number = self.freedoms.number(node);
                    heat[number] -= lost;
                    slopes.surfaces[number] += slope * slopes.varying.as_ref().map_or(1.0, |own| own.warm[number]);
                    sum += lost;
                },
            );
        }
        (sum, slopes)
    }

    /// What a kelvin of Kirchhoff's temperature conducts and loses, W/K: it conducts in proportion. Films between nodes of
    /// different properties are taken with the mean of two, which keeps the matrix symmetric and is near enough for Newton's
    /// steps.
    pub(super) fn tangent(&self, slopes: &Slopes) -> Matrix {
        let mut matrix = match (&self.varying, &slopes.varying) {
            (Some(varying), Some(relative)) => varying.tangent(relative, &self.conductance),
            _ => self.conductance.clone(),
        };
        for (number, slope) in slopes.surfaces.iter().enumerate().filter(|(_, slope)| **slope != 0.0) {
            matrix.add_diagonal(number, *slope);
        }
        matrix
    }

    /// What a kelvin of Kirchhoff's temperature stores, J/K, in the same way.
    pub(super) fn stored(&self, slopes: &Slopes) -> Matrix {
        match &slopes.varying {
            Some(relative) => self.capacity.averaged(&relative.enthalpies),
            None => self.capacity.clone(),
        }
    }
}

/// Whether temperatures that changed by so much at most (K) have come to rest.
pub(super) fn is_at_rest(change: f64) -> bool {
    change <= REST
}

fn check(law: &Conduction) -> Result<(), ThermalError> {
    for (value, quantity) in [
        (law.conductivity, "conductivity (W/(m K))"),
        (law.heat_capacity, "heat capacity (J/(m³ K))"),
        (law.thickness.scale(), "thickness (m)"),
    ] {
        ThermalError::check(value > 0.0 && value.is_finite(), quantity, "above zero", value)?;
    }
    Ok(())
}

fn check_film(film: f64) -> Result<(), ThermalError> {
    ThermalError::check(film >= 0.0 && film.is_finite(), "film coefficient (W/(m² K))", "zero or above", film)
}

/// Adds the convection of all sides to the conduction; the heat that it brings per kelvin of the
/// surroundings.
fn convections(
    conductance: &mut Matrix,
    mesh: &Mesh,
    freedoms: &Freedoms,
    law: &Conduction,
    conditions: &[Condition],
) -> Result<Vec<Supply>, ThermalError> {
    let mut ambients = Vec::new();
    for condition in conditions {
        if let Condition::Convection { sides, coefficient: film, ambient } = condition {
            check_film(*film)?;
            let sides = mesh.sides(sides)?;
            add_convection(conductance, mesh, freedoms, sides, (law.thickness, *film));
            let shares = side_shares(mesh, sides, law.thickness, *film);
            ambients.push(Supply { shares, amplitude: Amplitude::Varying(ambient.clone()) });
        }
    }
    Ok(ambients)
}

/// Nodes with a prescribed temperature, ascending, and their temperatures; where sides meet, the first
/// condition counts.
fn prescribed(mesh: &Mesh, conditions: &[Condition]) -> Result<(Vec<usize>, Vec<History>), ThermalError> {
    let mut held: Vec<(usize, History)> = Vec::new();
    for condition in conditions {
        if let Condition::Temperature { sides, temperature } = condition {
            let nodes = mesh.nodes_on(sides)?;
            held.extend(nodes.into_iter().map(|node| (node as usize, temperature.clone())));
        }
    }
    held.sort_by_key(|(node, _)| *node);
    held.dedup_by_key(|(node, _)| *node);
    Ok(held.into_iter().unzip())
}

/// Adds ∫ h Nₐ N_b t dl of the sides with a film coefficient h.
fn add_convection(
    matrix: &mut Matrix,
    mesh: &Mesh,
    freedoms: &Freedoms,
    sides: &[Side],
    (thickness, film): (Thickness, f64),
) {
    let factor = film * thickness.scale();
    for &side in sides {
        let products = mesh.curve(side).shape_products(thickness);
        let mut square: Square<1> = [[[[0.0]]; MAX_NODES]; MAX_NODES];
        for a in 0..EDGE_NODES {
            for b in 0..EDGE_NODES {
                square[a][b] = [[factor * products[a][b]]];
            }
        }
        matrix.add::<1>(freedoms, mesh.side_nodes(side).as_slice(), &square);
    }
}

/// Fluxes and sources.
fn supplies(
    mesh: &Mesh,
    law: &Conduction,
    conditions: &[Condition],
) -> Result<(Vec<Supply>, Vec<MovingStrip>), ThermalError> {
    let (mut supplies, mut strips) = (Vec::new(), Vec::new());
    for condition in conditions {
        match condition {
            Condition::Flux { sides, flux } => {
                let wrong = flux.infinite();
                ThermalError::check(wrong.is_none(), "flux (W/m²)", "finite", wrong.unwrap_or(0.0))?;
                let shares = side_shares(mesh, mesh.sides(sides)?, law.thickness, 1.0);
                supplies.push(Supply { shares, amplitude: Amplitude::Switched(flux.clone()) });
            }
            Condition::Source { shares, power } => {
                let wrong = power.infinite();
                ThermalError::check(wrong.is_none(), "power (W)", "finite", wrong.unwrap_or(0.0))?;
                let last = mesh.nodes().len() - 1;
                if let Some((node, _)) = shares.iter().find(|(node, _)| *node > last) {
                    return Err(ThermalError::UnknownNode { node: *node, last });
                }
                supplies.push(Supply { shares: shares.clone(), amplitude: Amplitude::Switched(power.clone()) });
            }
            Condition::MovingFlux { sides, flux, width, start, speed } => {
                let wrong = flux.infinite();
                ThermalError::check(wrong.is_none(), "flux (W/m²)", "finite", wrong.unwrap_or(0.0))?;
                let sides = mesh.sides(sides)?;
                strips.push(MovingStrip::new(mesh, sides, law.thickness, flux.clone(), [*width, *start, *speed])?);
            }
            Condition::Convection { .. }
            | Condition::Surface { .. }
            | Condition::Faces { .. }
            | Condition::Temperature { .. } => {}
        }
    }
    Ok((supplies, strips))
}
