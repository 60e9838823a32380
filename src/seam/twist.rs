//! Sets of seams that would make the surface one-sided: which seam to blame, and how to mend it.

use super::Face;
use super::correct::Request;
use super::cycle::{self, Tied};
use super::faces::{self, Colouring, Saying};
use super::misfaced;
use super::order;
use super::parity::Parity;
use crate::fault::Fault;
use crate::pattern::SeamPair;

/// Contradictory cycles that are reported at once: finding each costs a search over all panels.
const REPORTED: usize = 50;

/// Names listed in one sentence before it says how many more there are.
const NAMED: usize = 8;

/// One contradictory cycle.
pub(super) struct Twist {
    /// The seam of it that is blamed.
    pub seam: usize,
    /// What to tell of it.
    pub fault: Fault,
    /// The blamed seam as it could be sewn.
    pub corrected: Option<SeamPair>,
}

/// Finds panels whose stated faces are the trouble; then the smallest contradictory cycle, takes the blamed seam out,
/// and so on until none is left.
pub(super) fn find(
    request: &Request<'_>,
    stated: &[Option<Face>],
    colouring: &Colouring,
) -> Vec<Twist> {
    let nodes = stated.len() + 1;
    let mut ties = ties(request, stated, colouring);
    let mut twists = misfaced::find(request, stated, &mut ties);
    while twists.len() < REPORTED
        && let Some(cycle) = cycle::smallest(nodes, &ties)
    {
        let case = Case {
            request,
            cycle: &cycle,
            ties: &ties,
            nodes,
        };
        let Some(blamed) = case.blamed(colouring) else {
            break;
        };
        let twist = case.told(blamed);
        ties.retain(|tie| tie.seam != Some(twist.seam));
        twists.push(twist);
    }
    twists
}

/// What stated faces and the seams that must not twist say, in the order of ids.
fn ties(request: &Request<'_>, stated: &[Option<Face>], colouring: &Colouring) -> Vec<Tied> {
    let mut ties: Vec<Tied> = faces::stated_links(stated)
        .map(|link| Tied { link, seam: None })
        .collect();
    let mut sayings: Vec<&Saying<'_>> = request.sayings.iter().collect();
    sayings.sort_by_key(|saying| &saying.pair.id);
    for saying in sayings
        .into_iter()
        .filter(|saying| !saying.pair.allow_twist)
    {
        ties.extend(saying.links(colouring).iter().map(|&link| Tied {
            link,
            seam: Some(saying.seam),
        }));
    }
    ties
}

/// How many ties contradict those before them when some are left out, and what the rest say.
pub(super) fn without(ties: &[Tied], nodes: usize, out: impl Fn(&Tied) -> bool) -> (usize, Parity) {
    let mut parity = Parity::new(nodes);
    let mut contradictions = 0;
    for tie in ties.iter().filter(|tie| !out(tie)) {
        contradictions += usize::from(!parity.join(tie.link));
    }
    (contradictions, parity)
}

/// One cycle among all that is said.
struct Case<'a> {
    request: &'a Request<'a>,
    cycle: &'a [Tied],
    ties: &'a [Tied],
    nodes: usize,
}

impl Case<'_> {
    /// The seam without which fewest contradictions are left; of several the one that would start far shorter in the
    /// other order, then the one whose ends are upside down as drawn, then the one set last.
    fn blamed(&self, colouring: &Colouring) -> Option<&Saying<'_>> {
        let seams = self.cycle.iter().filter_map(|tie| tie.seam);
        let sayings = self.request.sayings;
        seams
            .filter_map(|seam| sayings.iter().find(|saying| saying.seam == seam))
            .min_by_key(|saying| {
                let (left, _) = without(self.ties, self.nodes, |tie| tie.seam == Some(saying.seam));
                (
                    left,
                    !order::is_far_apart(self.request, saying, colouring),
                    saying.heights_agree != Some(false),
                    usize::MAX - saying.seam,
                )
            })
    }

    fn told(&self, blamed: &Saying<'_>) -> Twist {
        let fault = Fault::new(
            "seam/twisted",
            format!("/seams/{}", blamed.seam),
            self.detail(blamed),
        );
        let (fix, corrected) = if let Some(fix) = self.turned_face() {
            (fix, None)
        } else if let Some(correction) = self.correction(blamed) {
            (correction.told, Some(correction.pair))
        } else {
            let fix = "pick another edge for side b, or its corners in the other order; \
                       set `allow_twist` only if a one-sided surface is wanted";
            (fix.to_owned(), None)
        };
        Twist {
            seam: blamed.seam,
            fault: fault.fix(fix),
            corrected,
        }
    }

    /// What to do where the stated face of a panel of the cycle is the trouble.
    fn turned_face(&self) -> Option<String> {
        let (now, _) = without(self.ties, self.nodes, |_| false);
        let panels = self.cycle.iter().filter(|tie| tie.seam.is_none());
        let (_, panel, up) = panels
            .map(|stated| {
                let (left, _) = without(self.ties, self.nodes, |tie| tie == stated);
                (left, stated.link.ends[0], stated.link.same)
            })
            .filter(|(left, ..)| *left < now)
            .min_by_key(|&(left, panel, _)| {
                (
                    left,
                    faces::is_front(self.request.pattern, panel),
                    usize::MAX - panel,
                )
            })?;
        let id = &self.request.pattern.panels[panel].id;
        let other = if up { "down" } else { "up" };
        Some(format!(
            "turn `{id}`: set its `face` to `{other}`, or to `auto`"
        ))
    }

    fn correction(&self, blamed: &Saying<'_>) -> Option<super::correct::Correction> {
        let (_, others) = without(self.ties, self.nodes, |tie| tie.seam == Some(blamed.seam));
        others
            .fits(&blamed.reversed)
            .then(|| self.request.correction(blamed))
            .flatten()
    }

    fn detail(&self, blamed: &Saying<'_>) -> String {
        let pairs = self.request.pairs;
        let seams = listed(
            self.cycle
                .iter()
                .filter_map(|tie| tie.seam)
                .map(|seam| &pairs[seam].id),
        );
        let panel_count = self.nodes - 1;
        let ends = self.cycle.iter().flat_map(|tie| tie.link.ends);
        let id = |panel: usize| &self.request.pattern.panels[panel].id;
        let panels = listed(ends.filter(|&end| end < panel_count).map(id));
        let stated = listed(
            self.cycle
                .iter()
                .filter(|tie| tie.seam.is_none())
                .map(|tie| id(tie.link.ends[0])),
        );
        let name = &blamed.pair.id;
        if self.cycle.len() == 1 {
            format!(
                "seam `{name}` twists {panels}: both of its sides go the same way round, so the outer side of the cloth would be sewn to the inner one"
            )
        } else if stated.is_empty() {
            format!(
                "seam `{name}` twists the garment: {seams} together, round {panels}, would sew the outer side of the cloth to the inner one"
            )
        } else {
            format!(
                "seam `{name}` does not go with the faces stated for {stated}: {seams} would sew the outer side of the cloth to the inner one"
            )
        }
    }
}

/// Names in quotation marks, each once, with "and" before the last.
pub(super) fn listed<'a>(names: impl Iterator<Item = &'a String>) -> String {
    let mut quoted: Vec<String> = vec![];
    for name in names.map(|name| format!("`{name}`")) {
        if !quoted.contains(&name) {
            quoted.push(name);
        }
    }
    if quoted.len() > NAMED {
        let more = quoted.len() - NAMED;
        quoted.truncate(NAMED);
        quoted.push(format!("{more} more"));
    }
    match quoted.pop() {
        Some(last) if !quoted.is_empty() => format!("{} and {last}", quoted.join(", ")),
        Some(last) => last,
        None => String::new(),
    }
}
