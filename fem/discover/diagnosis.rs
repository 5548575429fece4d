//! Diagnoses with laws: what the catalogue says is held against laws that are in no catalogue, by one criterion.

use super::fitted::{Ranked, fitted_settings, is_of};
use super::law::near;
use super::{CLEARLY, Candidate, Discovery, Explained, MOST_ROWS, ranked};
use crate::diagnose::{
    self, Cause, Diagnosis, FreeLaw, LargestChange, Missing, Rival, Verdict, thinned, thinned_to, under_noise, weight,
};
use crate::input::Parameter;
use crate::model::{Data, Edit, Entry, Model, Setting, add_effect};
use crate::process::{Description, Failure};
use crate::progress::Progress;

/// Effects that are as many as a law of two terms has constants.
const SEVERAL: usize = 3;
/// Share of the probability below which nothing is said of a law.
const UNLIKELY: f64 = 0.005;
/// Rise of −2 ln L above what the catalogue says from which nothing is said of a law, whatever its best values are.
const HOPELESS: f64 = 30.0;
/// Name of the step, for the note that it was left undone.
const LAWS: &str = "laws that are in no catalogue";

/// Searches for up to `most` effects that the model lacks and, where these leave something or say that the measurement is at
/// fault, for a law that explains more at its price.
///
/// # Errors
/// The data are too few, or the model cannot be computed.
pub fn diagnose(data: &Data, most: usize, progress: &Progress) -> Result<Diagnosis, Failure> {
    diagnose_with(data, &[], most, progress)
}

/// The same, with laws that somebody has in mind among those that are tried.
///
/// # Errors
/// As those of [`diagnose`].
pub fn diagnose_with(
    data: &Data,
    candidates: &[Candidate],
    most: usize,
    progress: &Progress,
) -> Result<Diagnosis, Failure> {
    let mut found = with_laws(data, candidates, most, progress)?;
    diagnose::doubt_sensors(&mut found);
    Ok(found)
}

fn with_laws(data: &Data, candidates: &[Candidate], most: usize, progress: &Progress) -> Result<Diagnosis, Failure> {
    let mut of_catalogue = diagnose::diagnose(data, most, progress)?;
    let is_over = matches!(of_catalogue.verdict, Verdict::Adequate | Verdict::NotJudged);
    if data.model.campaign().is_some() || is_over || !progress.permits(LAWS) {
        return Ok(of_catalogue);
    }
    let (mut best, mut held_back): (Option<Told>, Option<HeldBack>) = (None, None);
    // A law that says no more than the causes of the catalogue, under the noise that each leaves.
    let mut rival: Option<(Told, f64)> = None;
    let models = models(data, &of_catalogue);
    let is_all = explained(&of_catalogue).is_some();
    // Beside effects that explain everything nothing is left.
    for (number, model) in models.iter().enumerate().take(if is_all { 1 } else { usize::MAX }) {
        let causes = models.get(1).filter(|_| number == 0);
        match beside(data, model, candidates, most, (&of_catalogue, causes), progress) {
            Sought::Nothing => {}
            Sought::HeldBack(own) => held_back = held_back.or(Some(own)),
            Sought::Told(told, Some(share)) => rival = Some((*told, share)),
            Sought::Told(told, None) => {
                let leaves_nothing = told.diagnosis.verdict == Verdict::Adequate;
                // A law beside known causes goes before one in their place that says hardly more.
                if best.as_ref().is_none_or(|own| told.criterion < own.criterion + CLEARLY) {
                    best = Some(*told);
                }
                if leaves_nothing {
                    break;
                }
            }
        }
    }
    let explains = of_catalogue.missing.iter().any(|m| !m.describes());
    // Zeros that follow a column say less than a law of it.
    let follows = of_catalogue.missing.iter().any(|m| m.doubt.is_some() && sets_zero(&m.cause));
    let margin = if follows { -CLEARLY } else { CLEARLY };
    Ok(match best {
        Some(told) if told.criterion < of_catalogue.criterion - margin => told.over(of_catalogue, data),
        Some(told) if told.criterion < of_catalogue.criterion + CLEARLY && explains => {
            let share = told.share_beside(&of_catalogue);
            told.against(&mut of_catalogue, share);
            of_catalogue
        }
        _ => {
            if let Some(own) = held_back {
                own.against(&mut of_catalogue);
            }
            if let Some((law, share)) = rival {
                law.against(&mut of_catalogue, share);
            }
            of_catalogue
        }
    })
}

/// The share of the probability that a law has beside causes of the catalogue in its place, where the noise that each leaves is
/// settled alike: the diagnosis may have described that noise otherwise, and the law would take the credit. `None` where the law
/// leaves nothing that asks for it.
fn share_beside_causes(
    law: &Discovery<Ranked>,
    causes: &Model,
    found: &Diagnosis,
    data: &Data,
    progress: &Progress,
) -> Option<f64> {
    let weighed = law.weighed?;
    let own = data.beside(causes).ok()?;
    // Of as many rows as a law is sought in.
    let some = thinned_to(&own, MOST_ROWS);
    let own = some.as_ref().unwrap_or(&own);
    let of_machine = || found.missing.iter().filter(|m| is_of_machine(&m.cause));
    let numbers: usize = of_machine().map(|m| m.estimates.len()).sum();
    let width = of_machine().count() as f64 * (data.model.process.effects().len() as f64).ln();
    let price = numbers as f64 * (own.len() as f64).ln() + 2.0 * width;
    let of_causes = under_noise(own, progress).ok()?.criterion + price;
    Some(1.0 / (1.0 + weight(of_causes, weighed)))
}

/// What the catalogue says, where effects of the machine explain everything.
fn explained(diagnosis: &Diagnosis) -> Option<Explained> {
    let is_of_machine = || diagnosis.missing.iter().all(|m| is_of_machine(&m.cause));
    let terms = if diagnosis.missing.len() < SEVERAL { 1 } else { 2 };
    let is_all = diagnosis.verdict == Verdict::MissingEffect && is_of_machine();
    is_all.then_some(Explained { criterion: diagnosis.criterion, terms })
}

fn sets_zero(cause: &Cause) -> bool {
    matches!(cause, Cause::Measurement { effect, .. } if effect.sets_zero)
}

fn is_of_machine(cause: &Cause) -> bool {
    matches!(cause, Cause::Physical | Cause::Value { .. })
}

/// The models beside which laws are sought: as it is written, and with what the catalogue says of the machine, its values open.
fn models(data: &Data, diagnosis: &Diagnosis) -> Vec<Model> {
    let causes: Vec<&Missing> = diagnosis.missing.iter().filter(|m| is_of_machine(&m.cause)).collect();
    let mut completed = (!causes.is_empty()).then(|| data.model.clone());
    for missing in causes {
        completed = completed.and_then(|model| opened(&model, missing));
    }
    std::iter::once(data.model.clone()).chain(completed).collect()
}

/// A model with an effect more, or a value released, where a fit begins at what was found.
fn opened(model: &Model, missing: &Missing) -> Option<Model> {
    let values = missing.estimates.iter().map(|e| {
        let Parameter { path, kind, .. } = &e.parameter;
        (path, Entry::Text(near(kind.from_si(e.value), *kind)))
    });
    match missing.cause {
        Cause::Value { .. } => {
            let edits: Vec<Edit> = values.map(|(path, entry)| Edit::Set { path: path.clone(), entry }).collect();
            model.edited(&edits).ok()
        }
        _ => {
            let settings: Vec<Setting> =
                values.map(|(path, value)| Setting { key: path.key().into(), value }).collect();
            add_effect(model, &missing.effect.name, &settings).ok()
        }
    }
}

/// A law, and what the catalogue says beside it.
struct Told {
    law: FreeLaw,
    effect: Description,
    diagnosis: Diagnosis,
    criterion: f64,
}

/// What a search for a law beside a model comes to.
enum Sought {
    /// A law, with its share of the probability where causes of the catalogue in its place are likelier.
    Told(Box<Told>, Option<f64>),
    /// A law of what was set too seldom.
    HeldBack(HeldBack),
    Nothing,
}

/// A law of what was set too seldom to tell it from zeros of the settings.
struct HeldBack {
    /// The law, in words.
    text: String,
    /// Whether it would say as much as such zeros.
    is_likely: bool,
    /// What is told with it, where it would.
    told: Option<Box<Told>>,
}

impl HeldBack {
    /// Says of zeros that may be such a law that nobody knows whether the instrument makes them; and takes half of the
    /// probability, where it explains more than effects of the machine: these are not certain then.
    fn against(self, diagnosis: &mut Diagnosis) {
        let Self { text, is_likely, told } = self;
        let is_of_machine = diagnosis.missing.iter().any(|m| is_of_machine(&m.cause));
        if let Some(told) = told.filter(|told| is_of_machine && told.criterion < diagnosis.criterion - CLEARLY) {
            let share = told.share_beside(diagnosis).min(0.5);
            told.against(diagnosis, share);
        }
        let Some(zero) = diagnosis.missing.iter_mut().find(|m| sets_zero(&m.cause) && !m.describes()) else { return };
        if is_likely {
            zero.doubt = Some(format!("it may be {text}"));
            diagnosis.verdict = Verdict::beside_what_describes(&diagnosis.missing);
            diagnosis.verdict_after = diagnosis.verdict;
        } else {
            diagnosis.cautions.push(format!("what is said of the measurement may be {text}"));
        }
    }
}

/// The law that is told beside a model, and what the catalogue says of the model as it is written with that law; it is held
/// against what the catalogue says alone, and against the model with causes of the catalogue in its place.
fn beside(
    data: &Data,
    model: &Model,
    candidates: &[Candidate],
    most: usize,
    (of_catalogue, causes): (&Diagnosis, Option<&Model>),
    progress: &Progress,
) -> Sought {
    let Ok(own) = data.beside(model) else { return Sought::Nothing };
    let Ok(found) = ranked(&own, candidates, explained(of_catalogue), progress) else {
        return Sought::Nothing;
    };
    let limit = of_catalogue.criterion + HOPELESS;
    if found.told().is_none() {
        let Some(held_back) = held_back(data, &found) else { return Sought::Nothing };
        let told = if held_back.is_likely { told(data, found, (most, limit), progress) } else { None };
        return Sought::HeldBack(HeldBack { told: told.map(Box::new), ..held_back });
    }
    let share = causes.and_then(|causes| share_beside_causes(&found, causes, of_catalogue, data, progress));
    let share = share.filter(|share| *share < 0.5);
    if share.is_some_and(|share| share < UNLIKELY) {
        return Sought::Nothing;
    }
    // What a share says is asked for however far behind the law is.
    let limit = if share.is_some() { f64::INFINITY } else { limit };
    told(data, found, (most, limit), progress).map_or(Sought::Nothing, |told| Sought::Told(Box::new(told), share))
}

/// The best law, and what the catalogue says of the model as it is written with it; `None` where that cannot be computed, or
/// its criterion is beyond a limit.
fn told(data: &Data, mut found: Discovery<Ranked>, (most, limit): (usize, f64), progress: &Progress) -> Option<Told> {
    let law = found.laws.remove(0);
    let open = law.written.open();
    let model = add_effect(data.model, &law.name, &open).ok()?;
    let mut effect = model.effects.iter().find(|own| own.description.name == *law.name)?.description.clone();
    let own = data.beside(&model).ok()?;
    if !law.is_candidate {
        (effect.about, effect.source) = ("a law that is in no catalogue".into(), "found in these rows");
    }
    let diagnosis = diagnose::diagnose_beside_law(&own, most, limit - law.found.price, progress).ok()??;
    let criterion = diagnosis.criterion + law.found.price;
    let law = FreeLaw {
        observable: data.model.process.observables()[law.observable].name.clone(),
        formula: law.written.formula,
        variables: law.variables,
        settings: fitted_settings(&open, &diagnosis.fit, &law.name),
        like: found.like,
        rivals: found.laws.into_iter().map(|own| Rival { formula: own.written.formula, apart: own.apart }).collect(),
    };
    Some(Told { law, effect, diagnosis, criterion })
}

/// A law that is held back because what it is made of was set too seldom.
fn held_back(data: &Data, found: &Discovery<Ranked>) -> Option<HeldBack> {
    let law = found.laws.first().filter(|law| law.found.terms.len() == 1)?;
    let too_few = found.too_few.as_ref()?;
    let (names, observable) = (law.variables.join(", "), &data.model.process.observables()[law.observable].name);
    Some(HeldBack {
        text: format!("a law of {names}, {observable} + {}: {too_few}", law.written.formula),
        is_likely: found.ahead > -CLEARLY,
        told: None,
    })
}

impl Told {
    /// Its share of the probability beside a diagnosis.
    fn share_beside(&self, diagnosis: &Diagnosis) -> f64 {
        1.0 / (1.0 + weight(diagnosis.criterion, self.criterion))
    }

    /// Takes a share of the probability of a diagnosis: nothing that it does without is certain.
    fn against(self, diagnosis: &mut Diagnosis, share: f64) {
        if share < UNLIKELY {
            return;
        }
        diagnosis.posterior.share(share, &self.diagnosis.posterior);
        for missing in &mut diagnosis.missing {
            missing.probability = diagnosis.posterior.of(&missing.effect.name);
        }
        let FreeLaw { observable, formula, .. } = self.law;
        diagnosis.cautions.push(format!(
            "a law that is in no catalogue explains as much, with a probability of {:.0} %: {observable} + {formula}",
            100.0 * share
        ));
    }

    /// The diagnosis with the law in the place of one without.
    fn over(self, without: Diagnosis, data: &Data) -> Diagnosis {
        let Self { law, effect, mut diagnosis, criterion } = self;
        // Of two that are equally likely each has a half.
        let against = weight(without.criterion, criterion);
        let goodness = std::mem::replace(&mut diagnosis.before, without.before);
        let change = goodness.predicted.iter().zip(&diagnosis.before.predicted).map(|(with, alone)| with - alone);
        let own = diagnosis.fit.estimates.iter().filter(|e| is_of(&effect.name, e));
        let told = Missing {
            estimates: own.cloned().collect(),
            cause: Cause::Law(law),
            effect,
            before: Vec::new(),
            probability: 1.0 / (1.0 + against),
            p_value: against.min(1.0),
            largest_change: largest_change(&change.collect::<Vec<_>>(), data, &diagnosis),
            goodness,
            indistinguishable_from: Vec::new(),
            bend: None,
            doubt: None,
        };
        // A law describes: what it makes good is not explained.
        diagnosis.verdict = match diagnosis.verdict {
            Verdict::Adequate | Verdict::Unexplained | Verdict::NotJudged => Verdict::Unexplained,
            Verdict::MissingEffect | Verdict::PartlyExplained => Verdict::PartlyExplained,
        };
        diagnosis.features = without.features;
        diagnosis.missing.insert(0, told);
        diagnosis.criterion = criterion;
        diagnosis
    }
}

/// The largest change that a law makes in the rows, beside what the model's own values can do.
fn largest_change(changes: &[f64], data: &Data, diagnosis: &Diagnosis) -> Option<LargestChange> {
    let some = thinned(data);
    let used = some.as_ref().unwrap_or(data);
    (used.len() == changes.len()).then(|| LargestChange::of(changes, &diagnosis.fit.noise.sigma, used)).flatten()
}
