//! The events of each job that is not final, numbered, with a bounded past for clients that
//! reconnect.

use super::record::JobRecord;
use super::status::JobStatus;
use super::store::JobNotice;
use crate::progress::Progress;
use std::collections::{BTreeMap, VecDeque};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tokio::sync::broadcast::{self, error::RecvError};
use uuid::Uuid;

/// Number of past events kept of one job.
const PAST: usize = 256;
/// Number of jobs whose events are kept; those that nobody follows are dropped first.
const CHANNELS: usize = 4_096;
/// Number of ids of one attempt: ids keep growing over attempts and restarts, and stay below 2^53
/// for `JavaScript`.
const IDS_PER_ATTEMPT: u64 = 1_000_000;

/// An event of a job.
#[derive(Clone, Debug, PartialEq)]
pub struct JobEvent {
    /// Number that grows from event to event of one job.
    pub id: u64,
    /// Content of the event.
    pub kind: JobEventKind,
}

/// Content of an event.
#[derive(Clone, Debug, PartialEq)]
pub enum JobEventKind {
    /// The job came further.
    Progress(Progress),
    /// The status changed; the last event of a job has a final one.
    Status(Box<JobRecord>),
}

impl JobEvent {
    /// Creates the event of a job of which none is kept.
    pub(super) fn current(record: JobRecord) -> Self {
        Self {
            id: u64::from(record.attempts) * IDS_PER_ATTEMPT,
            kind: JobEventKind::Status(Box::new(record)),
        }
    }

    /// Creates the last event of a job that ended before anyone followed it.
    pub(super) fn last(record: JobRecord) -> Self {
        Self {
            id: (u64::from(record.attempts) + 1) * IDS_PER_ATTEMPT - 1,
            kind: JobEventKind::Status(Box::new(record)),
        }
    }

    /// Returns true if no event follows.
    pub fn is_last(&self) -> bool {
        matches!(&self.kind, JobEventKind::Status(record) if record.status.is_final())
    }
}

/// The events of one job, from a requested one to the last.
#[derive(Debug)]
pub struct JobEvents {
    past: VecDeque<JobEvent>,
    live: Option<broadcast::Receiver<JobEvent>>,
    /// Id of the last event that was handed out.
    last_seen: Option<u64>,
}

impl JobEvents {
    /// Events that are all known.
    pub(super) fn of(past: impl IntoIterator<Item = JobEvent>) -> Self {
        Self {
            past: past.into_iter().collect(),
            live: None,
            last_seen: None,
        }
    }

    /// Returns true if no event will come: the job has ended, and its last event was read before.
    pub fn is_over(&self) -> bool {
        self.past.is_empty() && self.live.is_none()
    }

    /// Adds the current state as the first event if none is kept and all are requested.
    pub(super) fn or_current(mut self, record: JobRecord, after: Option<u64>) -> Self {
        if self.past.is_empty() && after.is_none() {
            self.past.push_front(JobEvent::current(record));
        }
        self
    }

    /// Returns the next event; `None` after the last one, or when the service shuts down.
    ///
    /// A follower that falls far behind misses progress, never the last event.
    pub async fn next(&mut self) -> Option<JobEvent> {
        loop {
            let event = match self.past.pop_front() {
                Some(event) => event,
                None => receive(self.live.as_mut()?).await?,
            };
            // An older event that was still on its way when the current state was handed out.
            if self.last_seen >= Some(event.id) {
                continue;
            }
            self.last_seen = Some(event.id);
            if event.is_last() {
                self.past.clear();
                self.live = None;
            }
            return Some(event);
        }
    }
}

async fn receive(live: &mut broadcast::Receiver<JobEvent>) -> Option<JobEvent> {
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
pub(super) struct EventFeeds {
    // A std mutex: nothing waits while it is held, and the solver's threads use it too.
    feeds: Mutex<FeedTable>,
}

#[derive(Debug, Default)]
struct FeedTable {
    by_job: BTreeMap<Uuid, JobFeed>,
    is_closed: bool,
}

#[derive(Debug)]
struct JobFeed {
    past: VecDeque<JobEvent>,
    sender: broadcast::Sender<JobEvent>,
    attempt: u32,
    last_id: u64,
}

impl EventFeeds {
    /// Publishes a notice of the store to the followers of the job.
    pub(super) fn publish(&self, notice: JobNotice) {
        match notice {
            JobNotice::Status(record) => {
                let (id, attempt, status) = (record.id, record.attempts, record.status);
                self.send(id, attempt, JobEventKind::Status(record));
                if status.is_final() {
                    self.lock().by_job.remove(&id);
                }
            }
            JobNotice::Progress {
                job,
                attempt,
                progress,
            } => self.send(job, attempt, JobEventKind::Progress(progress)),
            JobNotice::Queued | JobNotice::Cancel(_) => {}
        }
    }

    fn send(&self, job: Uuid, attempt: u32, kind: JobEventKind) {
        let mut feeds = self.lock();
        if feeds.is_closed {
            return;
        }
        let feed = feeds.of(job);
        let first = u64::from(attempt) * IDS_PER_ATTEMPT + 1;
        feed.last_id = first.max(feed.last_id + 1);
        feed.attempt = attempt;
        let event = JobEvent {
            id: feed.last_id,
            kind,
        };
        if feed.past.len() == PAST {
            feed.past.pop_front();
        }
        feed.past.push_back(event.clone());
        // No receiver is no fault: nobody follows this job.
        let _ = feed.sender.send(event);
    }

    /// Returns the events of a job that is not final after event `after`, or from the first one
    /// kept.
    pub(super) fn follow(&self, job: Uuid, after: Option<u64>) -> JobEvents {
        let mut feeds = self.lock();
        if feeds.is_closed {
            return JobEvents::of([]);
        }
        let feed = feeds.of(job);
        let is_new = |event: &&JobEvent| after.is_none_or(|after| event.id > after);
        JobEvents {
            past: feed.past.iter().filter(is_new).cloned().collect(),
            live: Some(feed.sender.subscribe()),
            last_seen: None,
        }
    }

    /// Returns the latest progress of the present attempt, if one was published here.
    pub(super) fn latest(&self, record: &JobRecord) -> Option<Progress> {
        if record.status != JobStatus::Running {
            return None;
        }
        let feeds = self.lock();
        let feed = feeds.by_job.get(&record.id)?;
        if feed.attempt != record.attempts {
            return None;
        }
        feed.past.iter().rev().find_map(|event| match &event.kind {
            JobEventKind::Progress(progress) => Some(progress.clone()),
            JobEventKind::Status(_) => None,
        })
    }

    /// Ends the events of every follower for good.
    pub(super) fn close(&self) {
        let mut feeds = self.lock();
        feeds.is_closed = true;
        feeds.by_job.clear();
    }

    fn lock(&self) -> MutexGuard<'_, FeedTable> {
        self.feeds.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl FeedTable {
    fn of(&mut self, job: Uuid) -> &mut JobFeed {
        if self.by_job.len() >= CHANNELS && !self.by_job.contains_key(&job) {
            self.by_job
                .retain(|_, feed| feed.sender.receiver_count() > 0);
        }
        self.by_job.entry(job).or_insert_with(|| JobFeed {
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
    use crate::job::kind::JobKind;
    use jiff::Timestamp;

    #[test]
    fn ids_grow_though_an_old_event_comes_late() {
        let feeds = EventFeeds::default();
        let waits = JobRecord::queued(JobKind::Fit, Uuid::now_v7(), Timestamp::now());
        let mut runs = waits.clone();
        (runs.status, runs.attempts) = (JobStatus::Running, 1);
        let mut ends = runs.clone();
        ends.status = JobStatus::Succeeded;
        let mut events = feeds.follow(waits.id, None).or_current(runs.clone(), None);
        for record in [waits, runs, ends] {
            feeds.publish(JobNotice::Status(Box::new(record)));
        }
        let mut received = Vec::new();
        let runtime = tokio::runtime::Builder::new_current_thread().build();
        runtime.unwrap().block_on(async {
            while let Some(event) = events.next().await {
                received.push(event);
            }
        });
        assert!(received.windows(2).all(|pair| pair[0].id < pair[1].id));
        assert!(
            received.last().is_some_and(JobEvent::is_last),
            "{received:?}"
        );
        assert_eq!(received.len(), 3);
    }
}
