package org.evoloop.fleet.stream;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;

/**
 * The settings of a fleet's instance.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class FleetSettings {
    /** In between, an instance tells the others three times that it lives. */
    private static final Duration LEAST_SESSION = Duration.ofMillis(100);

    private static final Duration LONGEST_SESSION = Duration.ofHours(1);

    private String fleet = "evoloop";
    private Path stateDirectory = Path.of(System.getProperty("java.io.tmpdir"), "evoloop-fleet");
    private Duration patience = Duration.ofSeconds(30);
    private Duration commitInterval = Duration.ofMillis(100);
    private Duration clockAhead = Duration.ofMinutes(1);
    private Duration clockBehind = Duration.ofDays(7);
    private Duration session = Duration.ofSeconds(10);
    private TopicSettings topics = TopicSettings.DEFAULTS;
    private int threads = 1;
    private int standbys;
    private boolean wallClock = true;
    private boolean inMemory;

    private FleetSettings() {}

    /** The defaults. */
    public static FleetSettings defaults() {
        return new FleetSettings();
    }

    private FleetSettings(FleetSettings other) {
        fleet = other.fleet;
        stateDirectory = other.stateDirectory;
        patience = other.patience;
        commitInterval = other.commitInterval;
        clockAhead = other.clockAhead;
        clockBehind = other.clockBehind;
        session = other.session;
        topics = other.topics;
        threads = other.threads;
        standbys = other.standbys;
        wallClock = other.wallClock;
        inMemory = other.inMemory;
    }

    /** A copy for the fleet {@code name}, which is the prefix of its topics, and whose instances share the work. */
    public FleetSettings withFleet(String name) {
        if (!name.matches("[A-Za-z0-9._-]{1,100}")) {
            throw new IllegalArgumentException(
                    "the fleet's name is '" + name + "'; use letters, digits, '.', '_' and '-', 100 at most");
        }
        FleetSettings next = new FleetSettings(this);
        next.fleet = name;
        return next;
    }

    /** A copy with another directory for this machine's copy of the state, which may be lost. */
    public FleetSettings withStateDirectory(Path directory) {
        FleetSettings next = new FleetSettings(this);
        next.stateDirectory = Objects.requireNonNull(directory);
        return next;
    }

    /** A copy in which a command is carried out within {@code limit} or not at all, and given up after twice that. */
    public FleetSettings withPatience(Duration limit) {
        FleetSettings next = new FleetSettings(this);
        next.patience = atLeastMillis(limit, "patience");
        return next;
    }

    /**
     * A copy with another interval between commits, which make results visible: a shorter one reduces latency, a longer
     * one increases throughput.
     */
    public FleetSettings withCommitInterval(Duration interval) {
        FleetSettings next = new FleetSettings(this);
        next.commitInterval = atLeastMillis(interval, "commit interval");
        return next;
    }

    /** A copy in which records that are this far ahead of, or behind, this machine's clock are refused. */
    public FleetSettings withClockLimits(Duration ahead, Duration behind) {
        FleetSettings next = new FleetSettings(this);
        next.clockAhead = atLeastMillis(ahead, "clock limit");
        next.clockBehind = atLeastMillis(behind, "clock limit");
        return next;
    }

    /** A copy in which an instance that is silent for this long counts as failed, and others take its devices. */
    public FleetSettings withSession(Duration timeout) {
        if (timeout.compareTo(LEAST_SESSION) < 0 || timeout.compareTo(LONGEST_SESSION) > 0) {
            throw new IllegalArgumentException("the session timeout is " + timeout.toMillis() + " ms, allowed is "
                    + LEAST_SESSION.toMillis() + " to " + LONGEST_SESSION.toMillis());
        }
        FleetSettings next = new FleetSettings(this);
        next.session = timeout;
        return next;
    }

    /** A copy in which the topics for the instances' own state are created with these settings. */
    public FleetSettings withTopics(TopicSettings settings) {
        FleetSettings next = new FleetSettings(this);
        next.topics = Objects.requireNonNull(settings);
        return next;
    }

    /** A copy with this number of threads. */
    public FleetSettings withThreads(int number) {
        if (number < 1 || number > 1_000) {
            throw new IllegalArgumentException("threads is " + number + ", allowed is 1 to 1000");
        }
        FleetSettings next = new FleetSettings(this);
        next.threads = number;
        return next;
    }

    /** A copy in which this many other instances keep a copy of each device, and can take it over at once. */
    public FleetSettings withStandbys(int number) {
        if (number < 0 || number > 10) {
            throw new IllegalArgumentException("standbys is " + number + ", allowed is 0 to 10");
        }
        FleetSettings next = new FleetSettings(this);
        next.standbys = number;
        return next;
    }

    /** A copy in which only the timestamps of records advance the time, for tests and replays. */
    public FleetSettings withStreamTime() {
        FleetSettings next = new FleetSettings(this);
        next.wallClock = false;
        return next;
    }

    /** A copy in which devices are kept only in memory, not on disk. */
    public FleetSettings withDevicesInMemory() {
        FleetSettings next = new FleetSettings(this);
        next.inMemory = true;
        return next;
    }

    private static Duration atLeastMillis(Duration duration, String what) {
        if (duration.toMillis() < 1) {
            throw new IllegalArgumentException("the " + what + " is " + duration + ", allowed is 1 ms or more");
        }
        return duration;
    }

    /** The prefix of the topics' names, shared by the instances. */
    public String fleet() {
        return fleet;
    }

    /** The directory of the state on this machine. */
    public Path stateDirectory() {
        return stateDirectory;
    }

    /** The time limit of a command. */
    public Duration patience() {
        return patience;
    }

    /** The interval at which results become visible. */
    public Duration commitInterval() {
        return commitInterval;
    }

    /** How far ahead of this machine's clock a record may be. */
    public Duration clockAhead() {
        return clockAhead;
    }

    /** How far behind this machine's clock a record may be. */
    public Duration clockBehind() {
        return clockBehind;
    }

    /** How long an instance may be silent. */
    public Duration session() {
        return session;
    }

    /** The settings of the topics for the instances' own state. */
    public TopicSettings topics() {
        return topics;
    }

    /** The number of threads. */
    public int threads() {
        return threads;
    }

    /** How many copies of a device other instances keep. */
    public int standbys() {
        return standbys;
    }

    /** Whether time passes by this machine's clock. */
    public boolean isWallClock() {
        return wallClock;
    }

    /** Whether devices are kept in memory only. */
    public boolean isInMemory() {
        return inMemory;
    }
}
