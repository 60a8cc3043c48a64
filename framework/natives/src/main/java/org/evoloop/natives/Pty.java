package org.evoloop.natives;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.NativeLong;
import com.sun.jna.Platform;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * A pseudo-terminal: the device's end of a cable whose other end is a file that programs open as a serial port. Linux
 * only.
 *
 * <p>The line is raw and at 115200 baud from the start: no echo, no control characters. It has no RTS or DTR. The
 * kernel ignores the baud rate but {@linkplain #clientBaud() reports it}, so that a wrong rate can be simulated.
 *
 * <p>Threading: thread-safe, intended for one reading and any number of writing threads. No call blocks for longer than
 * {@value #LONGEST_WAIT_MILLIS} ms, and {@link #hangUp()} ends a waiting {@link #read} at once.
 *
 * @since 0.1
 */
public final class Pty implements AutoCloseable {
    /** The longest that {@link #read} waits. */
    public static final int LONGEST_WAIT_MILLIS = 200;

    /** The result of {@link #read} when no program has the port open, or after {@link #hangUp()}. */
    public static final int NO_CLIENT = -1;

    /** How long a read sleeps while there is no client; the kernel has no event for a new client. */
    private static final int NO_CLIENT_REST_MILLIS = 10;

    /** What the links of simulators point to. */
    private static final Pattern TERMINAL = Pattern.compile("/dev/pts/\\d+");

    private static final int POLL_ENTRY_BYTES = 8;
    private static final int POLL_EVENTS_OFFSET = 4;
    private static final int POLL_RESULT_OFFSET = 6;

    private final int master;
    private final int wakeUp;
    private final Path slavePath;
    private final @Nullable Path symlink;

    /** One lock per direction. Both are held while the descriptors are closed, so that they are not used afterwards. */
    private final Lock readLock = new ReentrantLock();

    private final Lock writeLock = new ReentrantLock();
    private volatile boolean hungUp;
    private final AtomicLong droppedBytes = new AtomicLong();

    private Pty(int master, int wakeUp, Path slavePath, @Nullable Path symlink) {
        this.master = master;
        this.wakeUp = wakeUp;
        this.slavePath = slavePath;
        this.symlink = symlink;
    }

    /**
     * A pseudo-terminal under the path that the kernel gives it.
     *
     * @throws IOException if the system cannot create one
     */
    public static Pty open() throws IOException {
        return make(null);
    }

    /**
     * A pseudo-terminal under a fixed path, a symbolic link, which {@link #hangUp()} removes. It replaces a link left
     * behind by an earlier simulator, and nothing else. Opening the same path again is like plugging the cable in again.
     *
     * @throws IOException if the system cannot create one, or if the path exists and is not a link to a pseudo-terminal
     *     that is gone
     */
    public static Pty open(Path symlink) throws IOException {
        if (Files.exists(symlink, LinkOption.NOFOLLOW_LINKS) && !Files.isSymbolicLink(symlink)) {
            throw new IOException(symlink + " exists and is not a symbolic link; remove it or choose another path");
        }
        if (Files.isSymbolicLink(symlink)) {
            Path target = Files.readSymbolicLink(symlink);
            if (!TERMINAL.matcher(target.toString()).matches()) {
                throw new IOException(symlink + " is a symbolic link to " + target
                        + ", which no simulator made; remove it or choose another path");
            }
            if (isLiving(target, symlink)) {
                throw new IOException(symlink + " is the port of a running simulator, " + target
                        + "; end that one or choose another path");
            }
        }
        return make(symlink);
    }

    /**
     * Whether a link's terminal is still the one for which the link was made. The kernel reuses the paths of terminals
     * that are gone; a terminal with a reused path is younger than the link.
     */
    private static boolean isLiving(Path terminal, Path symlink) throws IOException {
        try {
            return changed(terminal).compareTo(changed(symlink)) <= 0;
        } catch (NoSuchFileException gone) {
            return false;
        }
    }

    /** The time when a terminal or a link was created; reading and writing do not change it. */
    private static FileTime changed(Path path) throws IOException {
        return (FileTime) Files.getAttribute(path, "unix:ctime", LinkOption.NOFOLLOW_LINKS);
    }

    private static Pty make(@Nullable Path symlink) throws IOException {
        if (!Platform.isLinux()) {
            throw new IOException(
                    "pseudo-terminals are supported on Linux only; this is " + System.getProperty("os.name"));
        }
        NativeLibraries.loadJna();
        int master = LibC.check(
                LibC.posix_openpt(LibC.O_RDWR | LibC.O_NOCTTY | LibC.O_NONBLOCK | LibC.O_CLOEXEC), "posix_openpt");
        int wakeUp = -1;
        try {
            wakeUp = LibC.check(LibC.eventfd(0, LibC.O_NONBLOCK | LibC.O_CLOEXEC), "eventfd");
            Path slavePath = unlock(master);
            makeRaw(master);
            showNoClient(slavePath);
            if (symlink != null) {
                point(symlink, slavePath);
            }
            return new Pty(master, wakeUp, slavePath, symlink);
        } catch (IOException failure) {
            LibC.close(master);
            if (wakeUp >= 0) {
                LibC.close(wakeUp);
            }
            throw failure;
        }
    }

    private static Path unlock(int master) throws IOException {
        LibC.check(LibC.grantpt(master), "grantpt");
        LibC.check(LibC.unlockpt(master), "unlockpt");
        byte[] name = new byte[64];
        if (LibC.ptsname_r(master, name, new NativeLong(name.length)) != 0) {
            throw LibC.failure("ptsname_r");
        }
        return Path.of(Native.toString(name, StandardCharsets.UTF_8));
    }

    private static void makeRaw(int master) throws IOException {
        try (Memory termios = new Memory(LibC.TERMIOS_BYTES)) {
            LibC.check(LibC.tcgetattr(master, termios), "tcgetattr");
            LibC.cfmakeraw(termios);
            LibC.check(LibC.cfsetspeed(termios, LibC.B115200), "cfsetspeed");
            LibC.check(LibC.tcsetattr(master, LibC.TCSANOW, termios), "tcsetattr");
        }
    }

    /** Until its first client, a master looks connected. Opening and closing the slave once corrects that. */
    private static void showNoClient(Path slavePath) throws IOException {
        LibC.close(LibC.check(
                LibC.open(slavePath.toString(), LibC.O_RDWR | LibC.O_NOCTTY | LibC.O_CLOEXEC), "open " + slavePath));
    }

    private static void point(Path symlink, Path slavePath) throws IOException {
        try {
            if (Files.isSymbolicLink(symlink)
                    && TERMINAL.matcher(Files.readSymbolicLink(symlink).toString())
                            .matches()) {
                Files.delete(symlink);
            }
            // Fails if something has taken the place meanwhile.
            Files.createSymbolicLink(symlink, slavePath);
        } catch (FileAlreadyExistsException taken) {
            throw new IOException(symlink + " has just been made by another program; choose another path", taken);
        } catch (IOException failure) {
            throw new IOException(
                    "cannot make the symbolic link " + symlink + "; its folder must exist and be writable", failure);
        }
    }

    /** The file to open: the symbolic link if there is one, else {@link #slavePath()}. */
    public Path path() {
        return symlink != null ? symlink : slavePath;
    }

    /** The path given by the kernel, such as {@code /dev/pts/3}. */
    public Path slavePath() {
        return slavePath;
    }

    /**
     * Waits for bytes from the client.
     *
     * @param timeoutMillis how long to wait, at most {@value #LONGEST_WAIT_MILLIS}
     * @return the number of bytes read into the start of the buffer, 0 if none came in time, or {@link #NO_CLIENT},
     *     after a short sleep that keeps a loop of reads from spinning
     */
    public int read(byte[] buffer, int timeoutMillis) {
        readLock.lock();
        try {
            if (hungUp) {
                return NO_CLIENT;
            }
            int waitMillis = Math.max(0, Math.min(timeoutMillis, LONGEST_WAIT_MILLIS));
            int events = await(true, waitMillis);
            if ((events & LibC.POLLIN) != 0) {
                return take(buffer);
            }
            if ((events & LibC.POLLHUP) != 0) {
                await(false, Math.min(waitMillis, NO_CLIENT_REST_MILLIS));
                return NO_CLIENT;
            }
            return hungUp ? NO_CLIENT : 0;
        } finally {
            readLock.unlock();
        }
    }

    private int take(byte[] buffer) {
        int length = LibC.read(master, buffer, new NativeLong(buffer.length)).intValue();
        if (length >= 0) {
            return length;
        }
        int error = Native.getLastError();
        return error == LibC.EAGAIN || error == LibC.EINTR ? 0 : NO_CLIENT;
    }

    /** Polls for {@link #hangUp()}, and also for input if wanted; returns the master's events. */
    private int await(boolean input, int timeoutMillis) {
        try (Memory entries = new Memory(2L * POLL_ENTRY_BYTES)) {
            entries.clear();
            entries.setInt(0, wakeUp);
            entries.setShort(POLL_EVENTS_OFFSET, LibC.POLLIN);
            entries.setInt(POLL_ENTRY_BYTES, master);
            entries.setShort(POLL_ENTRY_BYTES + POLL_EVENTS_OFFSET, LibC.POLLIN);
            int ready = LibC.poll(entries, new NativeLong(input ? 2 : 1), timeoutMillis);
            return ready > 0 ? entries.getShort(POLL_ENTRY_BYTES + POLL_RESULT_OFFSET) : 0;
        }
    }

    /**
     * Sends bytes to the client without waiting: like a UART, the line does not care whether anybody listens. Without a
     * client all bytes are lost; bytes that do not fit into a client's full buffer are lost and counted.
     *
     * @param length how many, from the buffer's start
     * @return how many of them fit into the client's buffer
     */
    public int write(byte[] buffer, int length) {
        writeLock.lock();
        try {
            if (hungUp || !clientPresent()) {
                return 0;
            }
            int taken = 0;
            while (taken < length) {
                byte[] rest = taken == 0 ? buffer : Arrays.copyOfRange(buffer, taken, length);
                int written =
                        LibC.write(master, rest, new NativeLong(length - taken)).intValue();
                if (written > 0) {
                    taken += written;
                } else if (written == 0 || Native.getLastError() != LibC.EINTR) {
                    break;
                }
            }
            droppedBytes.addAndGet(length - taken);
            return taken;
        } finally {
            writeLock.unlock();
        }
    }

    /** Whether the cable has been pulled. */
    public boolean isHungUp() {
        return hungUp;
    }

    /** The number of bytes lost because a connected client's buffer was full. */
    public long droppedBytes() {
        return droppedBytes.get();
    }

    /** Whether a program has the port open. */
    public boolean clientPresent() {
        writeLock.lock();
        try {
            return !hungUp && (await(true, 0) & LibC.POLLHUP) == 0;
        } finally {
            writeLock.unlock();
        }
    }

    /** The baud rate chosen by the client, or by the latest one if there is none; 0 after {@link #hangUp()}. */
    public int clientBaud() {
        writeLock.lock();
        try (Memory termios2 = new Memory(LibC.TERMIOS_BYTES)) {
            if (hungUp || LibC.ioctl(master, LibC.TCGETS2, termios2) < 0) {
                return 0;
            }
            return termios2.getInt(LibC.TERMIOS2_OUTPUT_SPEED_OFFSET);
        } finally {
            writeLock.unlock();
        }
    }

    /** Pulls the cable: the client sees a hang-up and the symbolic link is gone. A second call does nothing. */
    public void hangUp() {
        writeLock.lock();
        try {
            if (hungUp) {
                return;
            }
            hungUp = true;
            LibC.write(wakeUp, new byte[] {1, 1, 1, 1, 1, 1, 1, 1}, new NativeLong(Long.BYTES));
            readLock.lock();
            try {
                removeSymlink();
                LibC.close(master);
                LibC.close(wakeUp);
            } finally {
                readLock.unlock();
            }
        } finally {
            writeLock.unlock();
        }
    }

    /** Leaves the link alone if it now points to another pseudo-terminal. */
    private void removeSymlink() {
        try {
            if (symlink != null && Files.readSymbolicLink(symlink).equals(slavePath)) {
                Files.delete(symlink);
            }
        } catch (IOException alreadyGone) {
            // The link has already been removed; the cable is pulled anyway.
        }
    }

    /** Same as {@link #hangUp()}. */
    @Override
    public void close() {
        hangUp();
    }
}
