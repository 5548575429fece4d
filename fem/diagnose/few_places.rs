//! Causes that stand on few places.

use super::candidate_model::CandidateModel;

/// Says that causes stand on few places of a coordinate along which a curve could be anything: with hardly
/// more places than parameters a few laws imitate any curve.
pub fn few_places(best: &CandidateModel) -> Option<String> {
    /// Places beyond the parameters from which a curve contradicts wrong laws.
    const MORE: usize = 3;
    let data = best.objective.data;
    let coordinates = data.model.process.coordinates();
    let (at, (name, _)) = data.given.iter().find_map(|i| Some((*i, coordinates[*i].curve?)))?;
    let places = data.levels(&[at]).into_iter().max().map_or(0, |most| most + 1);
    let free = best.objective.variables.len() - best.objective.priors();
    (!best.members.is_empty() && places < free + MORE).then(|| {
        let along = &coordinates[at].name;
        format!("{places} values of `{along}` hardly tell these causes from a {name}: measure at further ones between")
    })
}
