//! Workers on other machines, by `datafusion-distributed`: they get parts of a plan by gRPC, with
//! the texts of the robot files in it, and send rows back. Recordings and tables they read
//! themselves, from a common folder or an object store.
//!
//! A query fails with any of its workers. What has arrived is kept (a row is committed when it
//! comes), and the rest is asked of the workers that still answer.

mod leaves;
mod watch;

use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use async_trait::async_trait;
use datafusion::common::{Result, config_err};
use datafusion::execution::runtime_env::RuntimeEnv;
use datafusion::execution::{FunctionRegistry, SessionStateBuilder};
use datafusion::logical_expr::AggregateUDF;
use datafusion::prelude::SessionContext;
use datafusion_distributed::grpc::{BoxCloneSyncChannel, create_worker_client};
use datafusion_distributed::{
    ChannelResolver, DistributedExt, GetWorkerInfoRequest, SessionStateBuilderExt, Worker, WorkerChannel,
    WorkerQueryContext, WorkerResolver,
};
use futures::future::join_all;
use tonic::transport::server::TcpIncoming;
use tonic::transport::{Channel, Server};
use url::Url;

use crate::Fleet;
use crate::error::FleetError;
use crate::merge::MergeFactor;
use crate::recordings::{DoneForOthers, OfEachWorker};
use crate::robots::Robots;

/// A worker that is silent for the sum of both is dead: pings are sent so often, and waited for so
/// long.
const PING: Duration = Duration::from_secs(10);
const SILENCE: Duration = Duration::from_secs(20);

/// Time in which a worker says who it is.
const ANSWER: Duration = Duration::from_secs(5);

/// What worker and asker must agree on.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Addresses of workers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Workers(Vec<Url>);

impl Workers {
    /// Of addresses as `10.0.0.7:7070,arm-server:7070`.
    ///
    /// # Errors
    /// Where one is no address.
    pub fn parse(text: &str) -> Result<Self, FleetError> {
        let address = |word: &str| {
            let url =
                Url::parse(&format!("http://{word}")).ok().filter(|url| url.port().is_some() && url.path() == "/");
            let wrong = || FleetError::Option(format!("--workers: `{word}` is no address such as 10.0.0.7:7070"));
            url.ok_or_else(wrong)
        };
        let mut all: Vec<Url> =
            text.split(',').map(str::trim).filter(|word| !word.is_empty()).map(address).collect::<Result<_, _>>()?;
        all.sort();
        all.dedup();
        match all.is_empty() {
            true => Err(FleetError::Option("--workers: no address".into())),
            false => Ok(Self(all)),
        }
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// Those that answer, and why the others do not.
    ///
    /// # Errors
    /// Where none answers.
    pub async fn present(&self) -> Result<(Self, Vec<String>), FleetError> {
        let channels = Channels::default();
        let asked = self.0.iter().map(|url| async {
            let ask = async {
                let mut worker = channels.get_worker_client_for_url(url).await?;
                worker.get_worker_info(GetWorkerInfoRequest {}).await
            };
            match tokio::time::timeout(ANSWER, ask).await {
                Ok(Ok(info)) if info.version == VERSION => Ok(url.clone()),
                Ok(Ok(info)) => {
                    Err(format!("{} is of version {}, this program of {VERSION}", place(url), info.version))
                }
                Ok(Err(why)) => Err(format!("{} does not answer: {}", place(url), root(&why))),
                Err(_) => Err(format!("{} does not answer within {} s", place(url), ANSWER.as_secs())),
            }
        });
        let (mut present, mut absent) = (Vec::new(), Vec::new());
        for answer in join_all(asked).await {
            match answer {
                Ok(url) => present.push(url),
                Err(why) => absent.push(why),
            }
        }
        match present.is_empty() {
            true => Err(FleetError::NoWorker { why: absent.join("; ") }),
            false => Ok((Self(present), absent)),
        }
    }
}

fn place(url: &Url) -> &str {
    url.as_str().trim_start_matches("http://").trim_end_matches('/')
}

/// The innermost of an error's layers.
fn root(why: &dyn std::error::Error) -> String {
    let mut last = why;
    while let Some(inner) = last.source() {
        last = inner;
    }
    first_line(&last.to_string()).into()
}

/// Of an error that repeats itself in layers.
pub(crate) fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

impl WorkerResolver for Workers {
    fn get_urls(&self) -> Result<Vec<Url>> {
        // The planner keeps a plan of one task at home.
        let again = if self.0.len() == 1 { 2 } else { 1 };
        Ok(self.0.iter().cycle().take(again * self.0.len()).cloned().collect())
    }
}

/// Connections that notice a machine that vanished.
#[derive(Default)]
struct Channels(Mutex<BTreeMap<Url, Channel>>);

#[async_trait]
impl ChannelResolver for Channels {
    async fn get_worker_client_for_url(&self, url: &Url) -> Result<Box<dyn WorkerChannel>> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if !known.contains_key(url) {
            let endpoint = match Channel::from_shared(url.to_string()) {
                Ok(endpoint) => endpoint,
                Err(why) => return config_err!("{url}: {why}"),
            };
            let endpoint = endpoint.connect_timeout(ANSWER).http2_keep_alive_interval(PING);
            let channel = endpoint.keep_alive_timeout(SILENCE).keep_alive_while_idle(true).connect_lazy();
            known.insert(url.clone(), channel);
        }
        Ok(create_worker_client(BoxCloneSyncChannel::new(known[url].clone())))
    }
}

impl Fleet {
    /// A session whose recordings and factors are worked on by these workers, with so many
    /// partitions each.
    pub fn on(workers: &Workers, partitions: usize) -> Self {
        let robots = Arc::new(Robots::default());
        let state = SessionStateBuilder::new()
            .with_default_features()
            .with_config(Self::config(partitions).with_extension(Arc::new(OfEachWorker(partitions.max(1)))))
            .with_distributed_worker_resolver(workers.clone())
            .with_distributed_channel_resolver(Channels::default())
            .with_distributed_planner()
            .with_distributed_user_codec(leaves::Codec(Arc::clone(&robots)))
            .with_distributed_desired_task_count_handler(leaves::tasks)
            .with_distributed_scale_up_leaf_node_handler(leaves::share)
            .build();
        Self::with(SessionContext::new_with_state(state), robots, partitions)
    }
}

/// Works for others until the process ends. `ready` gets the address, which matters for port 0.
///
/// # Errors
/// Where the address can't be listened on, or a robot file has mistakes.
pub async fn serve(
    listen: SocketAddr,
    robots: &[PathBuf],
    ready: impl FnOnce(SocketAddr) -> Result<(), FleetError>,
) -> Result<(), FleetError> {
    let known = Arc::new(Robots::default());
    for path in robots {
        known.open(path)?;
    }
    let deaf = |source| FleetError::File { path: listen.to_string().into(), verb: "listened on", source };
    let listener = tokio::net::TcpListener::bind(listen).await.map_err(deaf)?;
    let runtime = Arc::new(RuntimeEnv::default());
    let stores = Arc::clone(&runtime);
    let done = Arc::new(DoneForOthers::default());
    let session = move |asked: WorkerQueryContext| {
        let (known, stores, done) = (Arc::clone(&known), Arc::clone(&stores), Arc::clone(&done));
        async move {
            let mut builder = asked.builder.with_distributed_user_codec(leaves::Codec(Arc::clone(&known)));
            builder.config().get_or_insert_default().set_extension(done);
            let mut state = builder.with_distributed_channel_resolver(Channels::default()).build();
            state.register_udaf(Arc::new(AggregateUDF::from(MergeFactor::default())))?;
            for own in crate::functions::all(&known, &stores) {
                state.register_udf(Arc::new(own))?;
            }
            Ok(state)
        }
    };
    let worker = Worker::from_session_builder(session).with_runtime_env(runtime).with_version(VERSION);
    ready(listener.local_addr().map_err(deaf)?)?;
    let mut server = Server::builder().http2_keepalive_interval(Some(PING)).http2_keepalive_timeout(Some(SILENCE));
    let served = server.add_service(worker.into_worker_server()).serve_with_incoming(TcpIncoming::from(listener));
    served.await.map_err(|why| deaf(std::io::Error::other(why)))
}
