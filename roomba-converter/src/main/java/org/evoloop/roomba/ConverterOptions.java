package org.evoloop.roomba;

import static java.util.Objects.requireNonNull;

import java.net.URI;
import java.nio.file.Path;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.time.Duration;
import java.time.LocalTime;
import java.time.format.DateTimeParseException;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.QuietHours;
import org.evoloop.journal.Journal;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.tool.CameraOptions;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.TimeOfWeek;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelFiles;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Mixin;

/** The options of the command line that choose how the converter works. */
final class ConverterOptions {
    private static final double USUAL_SPOT_WAIT_SECONDS = 5;

    @CommandLine.Option(
            names = "--models",
            paramLabel = "FILE",
            description = "XMI file with the diagrams 'original' and 'new' (default: models/cleaning-robot.xml).")
    private @Nullable Path models;

    @CommandLine.Option(
            names = "--original",
            paramLabel = "FILE#NAME",
            description = "The device's model, by diagram name, machine name or id; with --new, instead of --models.")
    private @Nullable String original;

    @CommandLine.Option(
            names = "--new",
            paramLabel = "FILE#NAME",
            description = "The model that the owner wants; with --original, instead of --models.")
    private @Nullable String evolved;

    @CommandLine.Option(
            names = "--time-unit",
            paramLabel = "ms|s",
            description = "Unit of the models' time triggers that have a number without one; unless given, those are "
                    + "refused.")
    private @Nullable String timeUnit;

    @CommandLine.Option(
            names = "--start-point",
            paramLabel = "X,Y",
            split = ",",
            description =
                    "Where Move drives to without a camera, in mm ahead and to the left of where the robot stands when "
                            + "the program starts (default: 1000,500).")
    private double @Nullable [] startPoint;

    @CommandLine.Option(
            names = "--search-limit",
            paramLabel = "SECONDS",
            defaultValue = "300",
            description = "How long Move looks for the starting point before it stops (default: ${DEFAULT-VALUE}).")
    private double searchLimitSeconds;

    @CommandLine.Option(
            names = "--camera",
            paramLabel = "SOURCE",
            description =
                    "The camera with which Move looks for the starting point's marker: a device such as /dev/video0 "
                            + "or 0, the URL of an HTTP camera, a recording, or with --simulate sim for the robot's "
                            + "own.")
    private @Nullable String camera;

    @Mixin
    private final CameraOptions cameraOptions = new CameraOptions();

    @CommandLine.Option(
            names = "--spot-wait",
            paramLabel = "SECONDS",
            description = "How long SpotWait waits for a second press (default: " + USUAL_SPOT_WAIT_SECONDS
                    + "); a time trigger in the model, such as tm(2s), says it there.")
    private @Nullable Double spotWaitSeconds;

    @CommandLine.Option(
            names = "--function",
            paramLabel = "STATE=FUNCTION",
            description =
                    "What runs in a new state: Move, SpotWait, SpotClean, Charge, QuietHours or none; can be repeated. "
                            + "By default, the one that the state's do activity names; otherwise Move runs in the one "
                            + "that arriveSpot leaves, SpotWait in the one that timeout leaves.")
    private List<String> functions = List.of();

    @CommandLine.Option(
            names = "--clean-at",
            paramLabel = "[DAYS ]TIME",
            description = "When the converter raises schedule, such as 09:00 or 'MON,FRI 09:00'; can be repeated. The "
                    + "robot's own schedule is switched off then.")
    private List<String> cleanAt = List.of();

    @CommandLine.Option(
            names = "--quiet-hours",
            paramLabel = "FROM-UNTIL",
            description = "When the function QuietHours has what the timetable begins wait, such as 22:00-07:00.")
    private @Nullable String quietHours;

    private @Nullable RobotModels read;

    /** Adds what annotations cannot say: allowed values beyond types, which values are paths, and alternatives. */
    static Options refined(Options options) {
        return options.refined("time-unit", units -> units.checkedBy(ModelReference::unit))
                .refined(
                        "search-limit",
                        limits -> limits.checkedBy(
                                text -> requireWithin("--search-limit", Double.parseDouble(text), 1, 3600)))
                .refined(
                        "spot-wait",
                        waits -> waits.checkedBy(
                                text -> requireWithin("--spot-wait", Double.parseDouble(text), 0.1, 3600)))
                .refined(
                        "camera",
                        cameras -> cameras.checkedBy(CameraSource::parse)
                                .placedBy((folder, text) -> isFile(text) ? Option.resolved(folder, text) : text)
                                .shownBy(CameraSource::masked))
                .refined("clean-at", times -> times.checkedBy(ConverterOptions::cleanAt))
                .refined("quiet-hours", hours -> hours.checkedBy(ConverterOptions::quietHours))
                .refined("original", models -> models.placedBy(Option::resolved))
                .refined("new", models -> models.placedBy(Option::resolved))
                .alternatives("camera", "start-point")
                .alternatives("calibration", "field-of-view")
                .alternatives("models", "original")
                .alternatives("models", "new");
    }

    /** @throws IllegalArgumentException if the text has another form */
    static TimeOfWeek cleanAt(String text) {
        return TimeOfWeek.parse("--clean-at", text);
    }

    /**
     * Parses a text such as {@code 22:00-07:00}.
     *
     * @throws IllegalArgumentException if the text has another form
     */
    static QuietHours quietHours(String text) {
        String[] parts = text.split("-", -1);
        try {
            if (parts.length == 2) {
                return QuietHours.between(LocalTime.parse(parts[0].strip()), LocalTime.parse(parts[1].strip()));
            }
        } catch (DateTimeParseException wrong) {
            // Reported below, as for any other text.
        }
        throw new IllegalArgumentException(
                "--quiet-hours is " + text + "; give two times of day, for example 22:00-07:00");
    }

    private static boolean isFile(String camera) {
        try {
            CameraSource.Kind kind = CameraSource.parse(camera).kind();
            return kind == CameraSource.Kind.FILE || kind == CameraSource.Kind.IMAGE_SEQUENCE;
        } catch (CameraException noCamera) {
            // Reported by the option's check.
            return false;
        }
    }

    /** Whether the camera is the simulated robot's own. */
    boolean wantsSimulatedCamera() {
        return CameraSource.SIMULATED.equals(camera);
    }

    /**
     * Reads the models, and checks options against each other.
     *
     * @param simulate whether the robot is simulated
     */
    void check(boolean simulate, Mistakes mistakes) {
        checkStartPoint(simulate, mistakes);
        ModelPair pair = pair(mistakes);
        read = pair == null
                ? null
                : mistakes.tried("function", Main::isUsersMistake, () -> RobotModels.of(pair, functions));
        if (read != null) {
            checkWith(read, mistakes);
        }
    }

    /** The models, once the options have been checked; null if they cannot be used. */
    @Nullable
    RobotModels models() {
        return read;
    }

    private void checkWith(RobotModels models, Mistakes mistakes) {
        if (spotWaitSeconds != null && !models.hasSpotWait()) {
            mistakes.add("--spot-wait says how long SpotWait lasts, but no state of the new model is left by timeout; "
                    + "leave the option out, a time trigger such as tm(2s) is in the model");
        }
        if (quietHours != null && !models.functions().containsValue(RobotFunction.QUIET_HOURS)) {
            mistakes.add("--quiet-hours says when QuietHours waits, but it runs in no state of the new "
                    + "model; leave the option out, or draw a state that is left by " + RobotEvents.QUIET_OVER);
        }
        if (!cleanAt.isEmpty() && !models.pair().evolved().triggers().contains(new Event(RobotEvents.SCHEDULE))) {
            mistakes.add("--clean-at raises " + RobotEvents.SCHEDULE
                    + ", which the new model does not know; leave the option out, or draw a transition for it");
        }
    }

    private void checkStartPoint(boolean simulate, Mistakes mistakes) {
        String wanted = camera;
        double[] point = startPoint;
        if (wanted != null) {
            if (point != null) {
                mistakes.add("--camera and --start-point both say where the starting point is; give one of them");
            }
            if (wantsSimulatedCamera() && !simulate) {
                mistakes.add("--camera sim goes with --simulate; a real robot has a real camera");
            }
            mistakes.tried("camera", Main::isUsersMistake, () -> cameraOptions.read(CameraSource.parse(wanted)));
        }
        if (point != null && (point.length != 2 || !Double.isFinite(point[0]) || !Double.isFinite(point[1]))) {
            mistakes.add("--start-point takes two numbers, X,Y in mm, for example 1000,500");
        }
    }

    /**
     * The options, once they have been checked.
     *
     * @param pace how many times faster than real time the robot runs
     * @param eyes what Move looks with; empty if it relies on the wheels
     * @param journal the converter's journal; null for none
     */
    RoombaOptions read(double pace, Optional<Eyes> eyes, @Nullable Path journal) {
        Double spotWait = spotWaitSeconds;
        String quiet = quietHours;
        return RoombaOptions.of(
                        requireNonNull(read),
                        eyes.<Function<Clock, StartPointSensor>>map(each -> each)
                                .orElseGet(this::byWheels))
                .withMove(MoveOptions.defaults()
                        .withLimit(seconds(searchLimitSeconds))
                        .atPace(pace))
                .withSpotWait(seconds(spotWait == null ? USUAL_SPOT_WAIT_SECONDS : spotWait))
                .withQuietHours(quiet == null ? QuietHours.none() : quietHours(quiet))
                .withTimetable(cleanAt.stream().map(ConverterOptions::cleanAt).toList())
                .withJournal(journal == null ? null : Journal.in(journal));
    }

    /** Checks the values of a command that takes no options file, as {@link #refined} does for others. */
    void checkRanges() {
        requireWithin("--search-limit", searchLimitSeconds, 1, 3600);
        if (spotWaitSeconds != null) {
            requireWithin("--spot-wait", spotWaitSeconds, 0.1, 3600);
        }
    }

    private static void requireWithin(String option, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            DecimalFormat plain = new DecimalFormat("0.###", DecimalFormatSymbols.getInstance(Locale.ROOT));
            throw new IllegalArgumentException(option + " is " + value + ", allowed is " + plain.format(least) + " to "
                    + plain.format(most) + " seconds");
        }
    }

    private static Duration seconds(double value) {
        return Duration.ofMillis(Math.round(value * 1000));
    }

    /**
     * What Move looks with; empty if it relies on the wheels.
     *
     * @param pace how many times faster than real time the robot runs
     * @param simulatedCamera the address of the simulated robot's camera, if it has one
     */
    Optional<Eyes> eyes(double pace, Optional<URI> simulatedCamera) {
        return Optional.ofNullable(camera)
                .map(wanted ->
                        CameraSource.parse(simulatedCamera.map(URI::toString).orElse(wanted)))
                .map(source -> new Eyes(cameraOptions.read(source), pace));
    }

    private Function<Clock, StartPointSensor> byWheels() {
        double[] point = startPoint;
        double[] known = point == null ? new double[] {Scenario.START_X_MM, Scenario.START_Y_MM} : point;
        return clock -> StartPointSensor.byWheels(known[0], known[1]);
    }

    private @Nullable ModelPair pair(Mistakes mistakes) {
        String from = original;
        String to = evolved;
        Path named = models;
        Optional<ChronoUnit> unit = Optional.ofNullable(timeUnit).map(ModelReference::unit);
        if (from == null && to == null) {
            return mistakes.tried("models", Main::isUsersMistake, () -> {
                Path file =
                        named == null ? ModelFiles.find("models/cleaning-robot.xml", ConverterOptions.class) : named;
                ModelFile whole = ModelFile.read(file);
                ModelFile machines = unit.map(whole::withTimeUnit).orElse(whole);
                return new ModelPair(named(machines.pick("original"), file), named(machines.pick("new"), file));
            });
        }
        if (from == null || to == null || named != null) {
            mistakes.add("--original and --new go together, and not with --models; give both or neither");
            return null;
        }
        StateMachine device = machine("original", from, unit, mistakes);
        StateMachine wanted = machine("new", to, unit, mistakes);
        return device == null || wanted == null ? null : new ModelPair(device, wanted);
    }

    private static @Nullable StateMachine machine(
            String option, String reference, Optional<ChronoUnit> unit, Mistakes mistakes) {
        return mistakes.tried(option, Main::isUsersMistake, () -> {
            ModelReference machine = ModelReference.parse(reference).withTimeUnit(unit);
            return named(machine.load(), machine.file());
        });
    }

    /** The machine with a name that includes its file, for messages. */
    private static StateMachine named(StateMachine machine, Path file) {
        return machine.withName(file + "#" + machine.name());
    }
}
