//! The events of each job that is not final, numbered, with a bounded past for those who come back.

use super::record::{JobRecord, Status};
use super::store::Notice;
use crate::progress::Progress;
use std::collections::{BTreeMap, VecDeque};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tokio::sync::broadcast::{self, error::RecvError};
use uuid::Uuid;

/// Events kept of one job.
const PAST: usize = 256;
/// Jobs whose events are kept; those nobody follows go first.
const CHANNELS: usize = 4_096;
/// Room for events of one attempt: ids keep growing over attempts and restarts, and stay below 2^53 for `JavaScript`.
const IDS_OF_ATTEMPT: u64 = 1_000_000;

/// Something that happened to a job.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Grows from event to event of one job.
    pub id: u64,
    /// What happened.
    pub kind: EventKind,
}

/// What happened to a job.
#[derive(Clone, Debug, PartialEq)]
pub enum EventKind {
    /// It came further.
    Progress(Progress),
    /// Its status changed; the last event of a job has a final one.
    Status(Box<JobRecord>),
}

impl Event {
    /// What is known of a job of which no event is kept.
    pub(super) fn now(record: JobRecord) -> Self {
        Self {
            id: u64::from(record.attempts) * IDS_OF_ATTEMPT,
            kind: EventKind::Status(Box::new(record)),
        }
    }

    /// The last event of a job that came to its end before anyone asked.
    pub(super) fn last(record: JobRecord) -> Self {
        Self {
            id: (u64::from(record.attempts) + 1) * IDS_OF_ATTEMPT - 1,
            kind: EventKind::Status(Box::new(record)),
        }
    }

    /// Whether no event follows.
    pub fn is_last(&self) -> bool {
        matches!(&self.kind, EventKind::Status(record) if record.status.is_final())
    }
}

/// The events of one job, from the one asked for to the last.
#[derive(Debug)]
pub struct Events {
    past: VecDeque<Event>,
    live: Option<broadcast::Receiver<Event>>,
    /// The last event that was handed out.
    seen: Option<u64>,
}

impl Events {
    /// Events that are all known.
    pub(super) fn of(past: impl IntoIterator<Item = Event>) -> Self {
        Self {
            past: past.into_iter().collect(),
            live: None,
            seen: None,
        }
    }

    /// The same events, begun with what is known now if none is kept and all were asked for.
    pub(super) fn or_now(mut self, record: JobRecord, after: Option<u64>) -> Self {
        if self.past.is_empty() && after.is_none() {
            self.past.push_front(Event::now(record));
        }
        self
    }

    /// The next event; `None` after the last one, or when the service shuts down.
    ///
    /// A follower that falls far behind misses progress, never the last event.
    pub async fn next(&mut self) -> Option<Event> {
        loop {
            let event = match self.past.pop_front() {
                Some(event) => event,
                None => received(self.live.as_mut()?).await?,
            };
            // Old news that was still on its way when what is known now was told.
            if self.seen >= Some(event.id) {
                continue;
            }
            self.seen = Some(event.id);
            if event.is_last() {
                self.past.clear();
                self.live = None;
            }
            return Some(event);
        }
    }
}

async fn received(live: &mut broadcast::Receiver<Event>) -> Option<Event> {
    loop {
        match live.recv().await {
            Ok(event) => return Some(event),
            Err(RecvError::Lagged(_)) => {}
            Err(RecvError::Closed) => return None,
        }
    }
}

/// The events of all jobs that are not final.
#[derive(Debug, Default)]
pub(super) struct Feeds {
    // A std mutex: nothing waits while it is held, and the solver's threads use it too.
    channels: Mutex<Channels>,
}

#[derive(Debug, Default)]
struct Channels {
    by_job: BTreeMap<Uuid, Channel>,
    closed: bool,
}

#[derive(Debug)]
struct Channel {
    past: VecDeque<Event>,
    sender: broadcast::Sender<Event>,
    attempt: u32,
    last_id: u64,
}

impl Feeds {
    /// Passes a notice of the store on to those who follow the job.
    pub(super) fn tell(&self, notice: Notice) {
        match notice {
            Notice::Status(record) => {
                let (id, attempt, status) = (record.id, record.attempts, record.status);
                self.send(id, attempt, EventKind::Status(record));
                if status.is_final() {
                    self.lock().by_job.remove(&id);
                }
            }
            Notice::Progress {
                job,
                attempt,
                progress,
            } => self.send(job, attempt, EventKind::Progress(progress)),
            Notice::Queued | Notice::Cancel(_) => {}
        }
    }

    fn send(&self, job: Uuid, attempt: u32, kind: EventKind) {
        let mut channels = self.lock();
        if channels.closed {
            return;
        }
        let channel = channels.of(job);
        let first = u64::from(attempt) * IDS_OF_ATTEMPT + 1;
        channel.last_id = first.max(channel.last_id + 1);
        channel.attempt = attempt;
        let event = Event {
            id: channel.last_id,
            kind,
        };
        if channel.past.len() == PAST {
            channel.past.pop_front();
        }
        channel.past.push_back(event.clone());
        // No receiver is no fault: nobody follows this job.
        let _ = channel.sender.send(event);
    }

    /// Follows a job that is not final from after event `after`, or from the first one kept.
    pub(super) fn follow(&self, job: Uuid, after: Option<u64>) -> Events {
        let mut channels = self.lock();
        if channels.closed {
            return Events::of([]);
        }
        let channel = channels.of(job);
        let is_new = |event: &&Event| after.is_none_or(|after| event.id > after);
        Events {
            past: channel.past.iter().filter(is_new).cloned().collect(),
            live: Some(channel.sender.subscribe()),
            seen: None,
        }
    }

    /// How far this attempt of a job is, as far as is known here.
    pub(super) fn latest(&self, record: &JobRecord) -> Option<Progress> {
        if record.status != Status::Running {
            return None;
        }
        let channels = self.lock();
        let channel = channels.by_job.get(&record.id)?;
        if channel.attempt != record.attempts {
            return None;
        }
        channel
            .past
            .iter()
            .rev()
            .find_map(|event| match &event.kind {
                EventKind::Progress(progress) => Some(progress.clone()),
                EventKind::Status(_) => None,
            })
    }

    /// Ends every follower's events for good.
    pub(super) fn close(&self) {
        let mut channels = self.lock();
        channels.closed = true;
        channels.by_job.clear();
    }

    fn lock(&self) -> MutexGuard<'_, Channels> {
        self.channels.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Channels {
    fn of(&mut self, job: Uuid) -> &mut Channel {
        if self.by_job.len() >= CHANNELS && !self.by_job.contains_key(&job) {
            self.by_job
                .retain(|_, channel| channel.sender.receiver_count() > 0);
        }
        self.by_job.entry(job).or_insert_with(|| Channel {
            past: VecDeque::new(),
            sender: broadcast::channel(PAST).0,
            attempt: 0,
            last_id: 0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::record::JobKind;
    use jiff::Timestamp;

    #[test]
    fn ids_grow_though_old_news_comes_late() {
        let feeds = Feeds::default();
        let waits = JobRecord::queued(JobKind::Fit, Uuid::now_v7(), Timestamp::now());
        let mut runs = waits.clone();
        (runs.status, runs.attempts) = (Status::Running, 1);
        let mut ends = runs.clone();
        ends.status = Status::Succeeded;
        let mut events = feeds.follow(waits.id, None).or_now(runs.clone(), None);
        for record in [waits, runs, ends] {
            feeds.tell(Notice::Status(Box::new(record)));
        }
        let mut told = Vec::new();
        let runtime = tokio::runtime::Builder::new_current_thread().build();
        runtime.unwrap().block_on(async {
            while let Some(event) = events.next().await {
                told.push(event);
            }
        });
        assert!(told.windows(2).all(|pair| pair[0].id < pair[1].id));
        assert!(told.last().is_some_and(Event::is_last), "{told:?}");
        assert_eq!(told.len(), 3);
    }
}
