package org.evoloop.service;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.evoloop.console.Console;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs a console unattended, according to {@link ServiceOptions}.
 *
 * <pre>{@code
 * try (Service service = Service.open(options)) {
 *     // ... build the converter and its console
 *     return service.run(console);
 * }
 * }</pre>
 *
 * <p>Lifecycle: {@link #open} takes the name before anything touches the device; {@link #run} opens control socket and
 * loop, notifies the service manager, and returns when the console has ended; {@link #close} releases the name, last of
 * all.
 *
 * <p>Threading: open, run and close on one thread.
 *
 * @since 0.1
 */
public final class Service implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Service.class);

    private final ServiceOptions options;
    private final Clock clock;
    private final Map<String, String> environment;
    private final @Nullable Path socket;
    private final @Nullable InstanceLock lock;
    private @Nullable ControlServer server;
    private volatile boolean closed;

    private Service(ServiceOptions options, Clock clock, Map<String, String> environment) throws IOException {
        this.options = options;
        this.clock = clock;
        this.environment = environment;
        String name = options.name();
        if (name == null) {
            socket = null;
            lock = null;
        } else {
            Path directory = new Instances(environment).directory();
            socket = Instances.socket(directory, name);
            PrivateDirectory.prepare(directory);
            lock = InstanceLock.acquire(directory, name);
        }
    }

    /**
     * Takes the name, if there is one.
     *
     * @throws IllegalArgumentException if a running instance has the name, or its socket's path would be too long
     * @throws IOException if the socket's directory cannot be used; the message says what to do
     */
    public static Service open(ServiceOptions options) throws IOException {
        return open(options, new SystemClock(), System.getenv());
    }

    /** Takes the name, using another environment and another clock, which it closes. */
    static Service open(ServiceOptions options, Clock clock, Map<String, String> environment) throws IOException {
        try {
            return new Service(options, clock, environment);
        } catch (IOException | RuntimeException refused) {
            clock.close();
            throw refused;
        }
    }

    /**
     * Runs {@code console} until it ends.
     *
     * @return the exit status for the process, see {@link Console#run}; 1 if one of the converter's components closed
     *     it while the program ran unattended
     * @throws IOException if the control socket cannot be opened
     */
    public int run(Console console) throws IOException {
        Path own = socket;
        if (own != null) {
            server = new ControlServer(own, Commands.of(console), clock);
            // In case the process ends without close().
            Runtime.getRuntime().addShutdownHook(new Thread(() -> remove(own), "evoloop-control-removal"));
        }
        String command = options.onTrouble();
        try (ServiceManager manager = new ServiceManager(environment, console, clock, options.start());
                TroubleHook hook = command == null
                        ? null
                        : new TroubleHook(command, console.converters(), clock, TroubleHook.LIMIT)) {
            if (hook != null) {
                console.onBegin(hook::start);
            }
            if (options.start()) {
                console.outliveInput();
                console.onBegin(() -> console.converters().forEach(SystemEventConverter::start));
            }
            // Only in the run do signals end the program in order, and a service manager may send one at once.
            console.onBegin(manager::ready);
            return console.run();
        }
    }

    private void remove(Path socket) {
        if (closed) {
            // The socket may already belong to another process.
            return;
        }
        try {
            Files.deleteIfExists(socket);
        } catch (IOException left) {
            // The next instance with this name removes it.
        }
    }

    /**
     * Releases the name, which notifies programs that wait for the end of this one, such as {@code ctl NAME exit}.
     * Idempotent.
     */
    @Override
    public void close() {
        ControlServer open = server;
        if (open != null) {
            open.close();
        }
        closed = true;
        if (lock != null) {
            try {
                lock.close();
            } catch (IOException failure) {
                LOG.warn("the name {} cannot be released: {}", options.name(), failure.getMessage());
            }
        }
        clock.close();
    }
}
