package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** An error that the user can fix gives one message, exit status 2, and nothing on standard output. */
class BadInputTest {
    private static final String ORIGINAL = Tool.ROBOT + "#original";
    private static final String NEW = Tool.ROBOT + "#new";

    private static void assertRefused(Tool refused, String... words) {
        assertThat(refused.status()).isEqualTo(2);
        assertThat(refused.out()).isEmpty();
        assertThat(refused.err()).startsWith("error: ").contains(words).doesNotContain("\tat ");
    }

    @Test
    void sayingNothingIsAnsweredWithWhatThereIs() {
        assertRefused(Tool.run(), "name a command", "show", "check", "diff", "plan", "migrate", "flatten", "scaffold");
    }

    @Test
    void wrongWordsAreNamed() {
        assertRefused(Tool.run("draw", NEW), "draw", "models --help");
        assertRefused(Tool.run("show", NEW, "--format", "gif"), "--format", "gif", "svg");
        assertRefused(Tool.run("show", NEW, "--colour"), "--colour");
        assertRefused(Tool.run("show"), "FILE[#NAME]");
        assertRefused(Tool.run("diff", NEW), "NEW");
    }

    @Test
    void filesAndMachinesThatAreNotThereAreNamed() {
        assertRefused(Tool.run("show", "nowhere.xml"), "nowhere.xml");
        assertRefused(Tool.run("show", Tool.ROBOT + "#old"), "'old'", "'original'", "'new'");
        assertRefused(Tool.run("flatten", Tool.ROBOT), "holds 2 state machines");
        assertRefused(Tool.run("plan", ORIGINAL, "nowhere.xml#new"), "nowhere.xml");
    }

    @Test
    void aFileThatIsNotAModelIsRefused(@TempDir Path directory) throws Exception {
        Path file = Files.writeString(directory.resolve("note.xml"), "<note/>");

        assertRefused(Tool.run("show", file.toString()), "note.xml", "note");
    }

    @Test
    void eventsAndStatesThatTheDeviceDoesNotHaveAreNamed() {
        assertRefused(Tool.run("plan", ORIGINAL, NEW, "--sendable", "Clean,Dock"), "--sendable", "Dock", "endSpot");
        assertRefused(Tool.run("plan", ORIGINAL, NEW, "--spontaneous", "timeout"), "--spontaneous", "timeout");
        assertRefused(Tool.run("plan", ORIGINAL, NEW, "--do-not-pass", "Move"), "--do-not-pass", "Move", "Spot");
        assertRefused(Tool.run("plan", ORIGINAL, NEW, "--cost", "Clean=0"), "cost", "Clean");
        assertRefused(Tool.run("plan", ORIGINAL, NEW, "--cost", "Clean=much"), "--cost", "much");
        assertRefused(
                Tool.run("plan", ORIGINAL, NEW, "--on-failure", "Clean=bak"), "--on-failure", "did you mean back");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--on-failure", "Spot@Off=back"), "--on-failure", "Spot@Off");
    }

    @Test
    void whatTheConverterIsSaidToHaveMustStandInAModel() {
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--functions", "Move,Wait"), "--functions", "Wait", "SpotWait");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--sends", "Move"), "--sends", "STATE=EVENT");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--sends", "On=Clean"), "--sends", "new state", "On", "Move");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--sends", "Move=Dock"), "--sends", "Dock", "Clean");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--raised", "arrive,Clean"), "--raised", "arrive", "arriveSpot");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--guards", "hot"), "--guards", "hot", "none");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--effects", "beep"), "--effects", "beep", "none");
    }

    @Test
    void whatIsNoFileOfPropertiesIsRefused(@TempDir Path directory) throws Exception {
        Path missing = directory.resolve("missing.txt");
        Path bytes = Files.write(directory.resolve("bytes.txt"), new byte[] {'a', (byte) 0xff});
        assertRefused(
                Tool.run("check", ORIGINAL, NEW, "--properties", missing.toString()), "missing.txt: does not exist");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--properties", directory.toString()), "is not a file");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--properties", bytes.toString()), "bytes.txt", "UTF-8");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // opening a pipe cannot be interrupted
    void pipesAndDevicesAreNoModels(@TempDir Path directory) throws Exception {
        Path pipe = directory.resolve("pipe.xml");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();

        assertRefused(Tool.run("show", pipe.toString()), "pipe.xml: is a pipe or a device");
        assertRefused(Tool.run("show", "/dev/zero"), "/dev/zero: is a pipe or a device");
        assertRefused(Tool.run("check", ORIGINAL, NEW, "--properties", "/dev/zero"), "/dev/zero: is larger than 1 MB");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // opening a pipe cannot be interrupted
    void propertiesMayComeFromAPipe(@TempDir Path directory) throws Exception {
        Path pipe = directory.resolve("pipe.txt");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        new ProcessBuilder("sh", "-c", "echo never Nowhere >\"$0\"", pipe.toString()).start();
        assertRefused(
                Tool.run("check", ORIGINAL, NEW, "--properties", pipe.toString()), "pipe.txt, line 1: ", "Nowhere");
    }

    @Test
    void aResultThatCannotBeWrittenIsAFailure() {
        CommandLine full = Main.commandLine();
        StringWriter err = new StringWriter();
        full.setErr(new PrintWriter(err));
        full.setOut(new PrintWriter(new Writer() {
            @Override
            public void write(char[] text, int from, int length) throws IOException {
                throw new IOException("No space left on device");
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        }));

        assertThat(Main.run(full, "show", NEW)).isEqualTo(1);
        assertThat(err).asString().startsWith("error: standard output: ").doesNotContain("\tat ");
    }

    @Test
    void aPairThatIsNotAnEvolutionHasNoPlan() {
        assertRefused(Tool.run("plan", NEW, ORIGINAL), "not an evolution", "Move", "SpotWait", "timeout");
    }

    @Test
    void aProjectNeedsAPackageAndAnEmptyDirectory(@TempDir Path directory) throws Exception {
        Files.writeString(directory.resolve("mine"), "");

        assertRefused(scaffold("lamp", directory), "--out", "not empty");
        assertRefused(scaffold("lamp", directory.resolve("mine")), "--out", "is a file");
        for (String wrong : new String[] {"com.new.lamp", "com..lamp", "1lamp", "", "a b", "java.lamp", "ラ.lamp"}) {
            assertRefused(scaffold(wrong, directory.resolve("free")), "--package", wrong);
        }
        assertThat(directory.resolve("free")).doesNotExist();
        assertRefused(
                Tool.run("scaffold", ORIGINAL, NEW, "--package", "lamp", "--update", "--out", directory.toString()),
                "--update",
                "no project of scaffold");
    }

    private static Tool scaffold(String javaPackage, Path directory) {
        return Tool.run("scaffold", ORIGINAL, NEW, "--package", javaPackage, "--out", directory.toString());
    }

    @Test
    void aPairThatCouldNotRunIsNotScaffolded(@TempDir Path directory) {
        Tool refused = Tool.run(
                "scaffold",
                NEW,
                ORIGINAL,
                "--package",
                "lamp",
                "--out",
                directory.resolve("lamp").toString());

        assertThat(refused.status()).isEqualTo(1);
        assertThat(refused.out()).isEmpty();
        assertThat(refused.err()).contains("condition-1", "condition-2", "fix:", "fix the models first");
        assertThat(directory.resolve("lamp")).doesNotExist();
    }

    @Test
    void helpIsAResult() {
        assertThat(Tool.run("--help").status()).isZero();
        assertThat(Tool.run("plan", "--help").out()).contains("--do-not-pass", "--cost", "--sendable");
    }
}
