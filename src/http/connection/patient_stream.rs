//! A connection whose client must take what is written to it.

use super::patience::Patience;
use std::io::{Error, ErrorKind, IoSlice, Result};
use std::pin::Pin;
use std::task::{Context, Poll};
use std::time::Instant;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::TcpStream;
use tokio::time::{Sleep, sleep};

/// A connection whose client must take what is written to it: it fails once the patience with the
/// client is used up.
pub(in crate::http) struct PatientStream {
    stream: TcpStream,
    patience: Patience,
    /// The wait of a write that the client does not take.
    wait: Option<(Instant, Pin<Box<Sleep>>)>,
}

impl PatientStream {
    /// Wraps a connection.
    pub(in crate::http) fn new(stream: TcpStream, patience: Patience) -> Self {
        Self {
            stream,
            patience,
            wait: None,
        }
    }

    /// Passes the result of a write on, or an error after too long a wait.
    fn watched(
        &mut self,
        written: Poll<Result<usize>>,
        cx: &mut Context<'_>,
    ) -> Poll<Result<usize>> {
        if let Poll::Ready(result) = written {
            let waited = self.wait.take().map(|(since, _)| since.elapsed());
            let bytes = result.as_ref().map_or(0, |bytes| *bytes);
            self.patience.note(waited.unwrap_or_default(), bytes);
            return Poll::Ready(result);
        }
        let left = self.patience.left();
        let start = || (Instant::now(), Box::pin(sleep(left)));
        let (_, timer) = self.wait.get_or_insert_with(start);
        match timer.as_mut().poll(cx) {
            Poll::Ready(()) => Poll::Ready(Err(Error::new(
                ErrorKind::TimedOut,
                "the client does not take its answer",
            ))),
            Poll::Pending => Poll::Pending,
        }
    }
}

impl AsyncRead for PatientStream {
    fn poll_read(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<Result<()>> {
        Pin::new(&mut self.stream).poll_read(cx, buffer)
    }
}

impl AsyncWrite for PatientStream {
    fn poll_write(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<Result<usize>> {
        let written = Pin::new(&mut self.stream).poll_write(cx, bytes);
        self.watched(written, cx)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        parts: &[IoSlice<'_>],
    ) -> Poll<Result<usize>> {
        let written = Pin::new(&mut self.stream).poll_write_vectored(cx, parts);
        self.watched(written, cx)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Result<()>> {
        Pin::new(&mut self.stream).poll_flush(cx)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(cx)
    }
}
