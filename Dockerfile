# The service in a container: docker build -t seamster . && docker run -e SEAMSTER_TOKENS=… -p 8737:8737 -v seamster:/data seamster
# The steps are the Makefile's recipes; tests/it/structure/house.rs keeps that so.

FROM rust:1.95-bookworm AS build
RUN apt-get update -q && apt-get install -qy --no-install-recommends nodejs npm && rm -rf /var/lib/apt/lists/*
WORKDIR /seamster
COPY . .
RUN make page
RUN make build

FROM debian:bookworm-slim
RUN useradd --system --uid 10001 --home-dir /data --create-home seamster
COPY --from=build /seamster/target/release/seamster /usr/local/bin/seamster
USER seamster
VOLUME /data
# Reached from outside the container, so it refuses to start without SEAMSTER_TOKENS; SEAMSTER_HOSTS names it to clients.
ENV SEAMSTER_LISTEN=0.0.0.0:8737 SEAMSTER_DATA=/data
EXPOSE 8737
HEALTHCHECK --interval=10s --timeout=3s --start-period=5s CMD ["seamster", "health"]
ENTRYPOINT ["seamster"]
CMD ["serve"]
