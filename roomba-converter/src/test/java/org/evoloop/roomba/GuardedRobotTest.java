package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.evoloop.JavaProcess;
import org.evoloop.roomba.OtherRobot.Truth;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Whatever ends or freezes the converter, the robot stands still in Passive mode within a second of its own time.
 * Robot, converter and guard are separate processes.
 */
@Timeout(value = 1800, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class GuardedRobotTest {
    private static final long LIMIT_MILLIS = 1_000;

    /** Move drives at 85 mm/s at most; positions are reported to a tenth of a millimetre. */
    private static final double LIMIT_MM = 85 + 1;

    /** A starting point so far away that no Move arrives: the wheel counts continue when the robot is carried back. */
    private static final String FAR_AWAY = "100000,0";

    /** The lines to type to make it drive. */
    private static final String MOVE = "press clean\npress spot\n";

    /** The command that the unit runs when the service has ended. */
    private static final Path MAKE_SAFE =
            Path.of(System.getProperty("evoloop.root"), "framework/package/root/usr/lib/evoloop/make-safe");

    private final Random random = new Random(20_261_123);
    private OtherRobot robot;
    private long longestMillis;
    private double farthestMm;

    @TempDir
    private Path folder;

    @BeforeEach
    void startTheRobot() throws IOException {
        robot = new OtherRobot();
    }

    @AfterEach
    void leaveNoProcess() {
        robot.close();
    }

    private Process start(String... options) throws IOException {
        List<String> arguments = new ArrayList<>(List.of("--start-point", FAR_AWAY));
        arguments.addAll(List.of(options));
        return robot.convert(folder.resolve("log"), arguments.toArray(String[]::new));
    }

    private String log() throws IOException {
        return Files.readString(folder.resolve("log"));
    }

    /**
     * Starts a converter, types {@code lines}, and waits for their effect.
     *
     * <p>A converter that gets no processor time for half a second rightly makes its robot safe and fails the press;
     * then another one is started.
     */
    private Process startUntil(Predicate<Truth> wanted, String lines, String... options) throws Exception {
        for (int life = 1; ; life++) {
            Process converter = start(options);
            OtherRobot.type(converter, lines);
            if (comesAbout(wanted, life < 4)) {
                return converter;
            }
            converter.destroyForcibly().waitFor();
        }
    }

    /** @param mayFail whether it may also fail to happen for half a minute */
    private boolean comesAbout(Predicate<Truth> wanted, boolean mayFail) {
        Truth before = robot.truth();
        Truth after = robot.await(
                "what was pressed comes about",
                now -> wanted.test(now) || (mayFail && now.millis() - before.millis() > 30_000));
        return wanted.test(after);
    }

    private void moveAgain(Process converter) throws IOException {
        int presses = 0;
        do {
            OtherRobot.type(converter, "press spot\n");
            presses++;
        } while (!comesAbout(GuardedRobotTest::isMove, presses < 4));
    }

    private static boolean isMove(Truth now) {
        return now.mode().equals("safe") && now.left() > 40 && now.right() > 40;
    }

    /** Lets Move drive for a random time. */
    private Truth driveOn() {
        Truth begun = robot.truth();
        long moment = random.nextInt(2_000);
        return robot.await("some time", now -> now.millis() - begun.millis() >= moment);
    }

    private void assertMadeSafe(Truth before) {
        Truth safe = robot.await("it is safe", now -> !now.drives() && now.isPassive());
        assertThat(safe.millis() - before.millis()).isLessThanOrEqualTo(LIMIT_MILLIS);
        assertThat(safe.mmFrom(before)).isLessThanOrEqualTo(LIMIT_MM);
        longestMillis = Math.max(longestMillis, safe.millis() - before.millis());
        farthestMm = Math.max(farthestMm, safe.mmFrom(before));
    }

    /** The robot's greatest speed during this many milliseconds of its time. */
    private double fastestFor(long millis) {
        Truth first = robot.truth();
        double fastest = 0;
        for (Truth now = first; now.millis() - first.millis() < millis; now = robot.truth()) {
            fastest = Math.max(fastest, Math.max(Math.abs(now.left()), Math.abs(now.right())));
        }
        return fastest;
    }

    private void kill(int times) throws Exception {
        for (int life = 0; life < times; life++) {
            Process converter = startUntil(GuardedRobotTest::isMove, MOVE);
            driveOn();
            Truth before = robot.truth();
            converter.destroyForcibly();
            assertMadeSafe(before);
            assertThat(fastestFor(300)).isZero();
            robot.execute("place 0 0 0");
        }
        progress(times + " kills");
    }

    private void progress(String what) {
        System.out.printf(Locale.ROOT, "%s: safe after %d ms and %.1f mm at most%n", what, longestMillis, farthestMm);
    }

    private void freeze(int times) throws Exception {
        Process converter = startUntil(GuardedRobotTest::isMove, MOVE);
        for (int freeze = 0; freeze < times; freeze++) {
            if (freeze > 0) {
                moveAgain(converter);
            }
            driveOn();
            Truth before = robot.truth();
            JavaProcess.signal("STOP", converter);
            assertMadeSafe(before);
            long moment = random.nextInt(3_000);
            robot.await("some time", now -> now.millis() - before.millis() >= moment);
            JavaProcess.signal("CONT", converter);
            assertThat(fastestFor(1_000)).as("it does not continue driving").isZero();
            robot.await("it is under control again", now -> now.mode().equals("safe") && !now.drives());
            assertThat(fastestFor(300)).isZero();
            robot.execute("place 0 0 0");
        }
        progress(times + " freezes");
        OtherRobot.type(converter, "status\nexit\n");
        assertThat(converter.waitFor()).isZero();
        assertThat(log()).contains("this program was frozen for", "states      original On, new On");
    }

    @Test
    void theRobotStopsWhenTheConverterIsKilled() throws Exception {
        kill(3);
    }

    @Test
    void theRobotStopsWhenTheConverterIsFrozenAndDoesNotDriveOnWhenItResumes() throws Exception {
        freeze(2);
    }

    @Test
    void aRobotAtItsOtherRateIsStoppedAsWell() throws Exception {
        robot.close();
        robot = new OtherRobot("--baud=19200");
        kill(1);
        freeze(1);
    }

    @Test
    @Tag("slow")
    void theRobotStopsAfterEachOfAHundredKillsAndTwentyFreezes() throws Exception {
        kill(100);
        freeze(20);
    }

    @Test
    void aFrozenGuardIsReplacedAndTheNextOneStopsTheRobot() throws Exception {
        Process converter = startUntil(GuardedRobotTest::isMove, MOVE);
        ProcessHandle guard = converter.children().findFirst().orElseThrow();
        assertThat(new ProcessBuilder("bash", "-c", "kill -STOP " + guard.pid())
                        .start()
                        .waitFor())
                .isZero();
        // Within a second; a busy computer gets some more.
        guard.onExit().get(4, TimeUnit.SECONDS);
        robot.await("another one guards", now -> converter.children().anyMatch(ProcessHandle::isAlive));
        Truth before = driveOn();
        converter.destroyForcibly();
        assertMadeSafe(before);
    }

    @Test
    void aRobotThatCleansByItselfContinues() throws Exception {
        Process converter =
                startUntil(now -> now.activity().equals("clean") && now.drives(), "press clean\npress clean\n");
        Truth before = robot.truth();
        JavaProcess.signal("STOP", converter);
        robot.await("some time", now -> now.millis() - before.millis() > 1_500);
        assertThat(robot.truth().activity()).isEqualTo("clean");
        converter.destroyForcibly();
        robot.await("some time", now -> now.millis() - before.millis() > 2_500);
        assertThat(robot.truth().activity()).isEqualTo("clean");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "program: roomba\nport: '%s' # the robot's\n",
                "connections:\n  robot: {roomba: %s, start-point: \"1000,0\"}\n",
                "connections:\n  robot:\n    guard: false\n    'roomba':  \"%s\"\n"
            })
    void withoutAGuardTheRobotDrivesOnUntilTheServiceHasEnded(String file) throws Exception {
        Process converter = startUntil(GuardedRobotTest::isMove, MOVE + "status\n", "--no-guard");
        driveOn();
        Truth before = robot.truth();
        converter.destroyForcibly();
        Truth later = robot.await("some time", now -> now.millis() - before.millis() > 2_000);
        assertThat(later.drives()).isTrue();
        assertThat(log()).contains("link        up").doesNotContain("guarded");

        stopPost(String.format(file, robot.port()));
        assertMadeSafe(robot.truth());
    }

    private void stopPost(String file) throws Exception {
        Path options = Files.writeString(folder.resolve("roomba.yaml"), file);
        Process stopPost = new ProcessBuilder("sh", MAKE_SAFE.toString(), options.toString())
                .redirectErrorStream(true)
                .start();
        assertThat(stopPost.waitFor()).isZero();
    }
}
