// SPDX-License-Identifier: MIT
// What Emscripten's NODERAWFS lacks: the environment; which of streams 0 to 2 are
// terminals, and their stat; files that are pipes; dup3; the signal of a closed pipe;
// and poll, which says that a read would wait, so that what was read is answered.
mergeInto(LibraryManager.library, {
  $STREAMS__deps: ['$FS', '$NODERAWFS', '$ENV'],
  $STREAMS__postset: `
    Object.assign(ENV, process.env);
    (function (fs, create, open, close, stat, write) {
      FS.createStandardStreams = function () {
        create();
        for (var i = 0; i < 3; i++)
          Object.assign(FS.streams[i], { path: i, tty: require('tty').isatty(i) });
      };
      FS.open = function () {
        var stream = open.apply(this, arguments);
        stream.seekable = fs.fstatSync(stream.nfd).isFile();
        return stream;
      };
      FS.close = function (stream) { // streams 0 to 2 are Node's, too
        return stream.nfd > 2 ? close(stream) : FS.closeStream(stream.fd);
      };
      FS.stat = function (path) {
        return typeof path === 'number' ? fs.fstatSync(path) : stat(path);
      };
      FS.write = function () {
        try {
          return write.apply(this, arguments);
        } catch (e) {
          if (e.errno === ERRNO_CODES.EPIPE && process.platform !== 'win32') {
            process.kill(process.pid, 'SIGPIPE');
            process.exit(141);
          }
          throw e;
        }
      };
    })(require('fs'), FS.createStandardStreams, FS.open, FS.close, FS.stat, FS.write);`,
  $STREAMS: {},
  __syscall_poll__deps: ['$STREAMS'],
  __syscall_poll: function (fds, n, timeout) {
    if (timeout)
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 10);
    return timeout ? n : 0;
  },
  __syscall_dup3: function (from, to, flags) {
    FS.streams[to] = Object.assign({}, FS.streams[from], { fd: to });
    return to;
  },
});
