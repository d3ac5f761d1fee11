//! A pool of independent jobs that run on all processors, the longest first.

use std::sync::{Mutex, PoisonError, mpsc};

/// Independent jobs, each with a variable for its result. The results do not depend on the order or the threads of execution.
#[derive(Default)]
pub struct JobPool<'s> {
    jobs: Vec<Job<'s>>,
}

struct Job<'s> {
    /// The approximate time in seconds.
    cost: f64,
    work: Box<dyn FnOnce() + Send + 's>,
}

impl<'s> JobPool<'s> {
    /// Adds a job. Its cost, roughly in seconds, determines the order of execution and its share of the progress.
    pub fn add<T: Send>(&mut self, cost: f64, place: &'s mut Option<T>, work: impl FnOnce() -> T + Send + 's) {
        self.jobs.push(Job { cost, work: Box::new(move || *place = Some(work())) });
    }

    /// Runs all jobs, and calls `done` with the completed fraction of the work, from 0 to 1.
    pub fn work(mut self, mut done: impl FnMut(f64)) {
        self.jobs.sort_by(|a, b| b.cost.total_cmp(&a.cost));
        let all: f64 = self.jobs.iter().map(|job| job.cost).sum();
        let hands = std::thread::available_parallelism().map_or(1, usize::from).min(self.jobs.len());
        let jobs = Mutex::new(self.jobs.into_iter());
        // a panic in a job ends the scope, so that a poisoned list is never used further
        let next = || jobs.lock().unwrap_or_else(PoisonError::into_inner).next();
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            for _ in 0..hands {
                let (sender, next) = (sender.clone(), &next);
                scope.spawn(move || {
                    while let Some(Job { cost, work }) = next() {
                        work();
                        // the receiver exists as long as this scope
                        let _ = sender.send(cost);
                    }
                });
            }
            drop(sender);
            receiver.iter().fold(0.0, |sum, cost| {
                done((sum + cost) / all);
                sum + cost
            });
        });
    }
}

#[cfg(test)]
mod tests {
    use super::JobPool;

    #[test]
    fn every_result_is_in_its_place() {
        let mut places: Vec<Option<usize>> = vec![None; 50];
        let mut crew = JobPool::default();
        for (number, place) in places.iter_mut().enumerate() {
            crew.add((number % 7) as f64 + 1.0, place, move || number * number);
        }
        let mut last = 0.0;
        crew.work(|fraction| {
            assert!(fraction > last);
            last = fraction;
        });
        assert!((last - 1.0).abs() < 1e-12);
        assert!(places.into_iter().enumerate().all(|(number, place)| place == Some(number * number)));
    }

    #[test]
    fn no_work_is_done_at_once() {
        JobPool::default().work(|_| panic!("nothing was done"));
    }
}
