# The two commands of the README on Debian 12.
#   docker build -t femsph .
#   docker run --rm -v "$PWD/out:/femsph/out" femsph build/release/femsph study spacing --out out
FROM debian:12
COPY . /femsph
WORKDIR /femsph
RUN apt-get update && studies/run && tests/run
CMD ["build/release/femsph", "--help"]
