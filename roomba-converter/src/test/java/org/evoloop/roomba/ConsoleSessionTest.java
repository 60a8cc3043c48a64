package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The program's console when its commands come through a pipe. */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class ConsoleSessionTest {
    @TempDir
    Path folder;

    @Test
    void startsPressesPrintsItsStatusAndExits() throws Exception {
        Program.Result result = Program.runWithInput(
                folder, "start\npress clean\nstatus --json\nexit\n", "--simulate", "--speed", "20");
        assertThat(result.err()).isEmpty();
        assertThat(result.status()).isZero();
        List<String> json =
                result.out().lines().filter(line -> line.startsWith("{")).toList();
        assertThat(json).hasSize(1);
        assertThat(json.get(0))
                .startsWith("{\"name\":\"roomba\",\"loop\":\"running\",")
                .contains("\"name\":\"MonitorEvent\"", "\"name\":\"Controller\"", "\"name\":\"ExecuteCommand\"")
                .contains("\"link\":{\"up\":true,")
                .endsWith("}");
    }

    @Test
    void aMistypedCommandIsOneLineOnStandardErrorAndTheConsoleContinues() throws Exception {
        Program.Result result = Program.runWithInput(
                folder,
                "press brush\nrobot place 500 -250.5 90\nrobot dance\nrobot state\nlist\n",
                "--simulate",
                "--speed",
                "20");
        assertThat(result.err().lines())
                .containsExactly("error: the controller has no button brush; it has clean and spot");
        assertThat(result.out().lines())
                .contains("ok")
                .anyMatch(line -> line.startsWith("{") && line.contains("\"xMm\":500") && line.contains("\"yMm\":-250"))
                .anyMatch(line -> line.startsWith("error: 'dance' is not a command; there are press clean|spot|dock"))
                .last()
                .isEqualTo("spares      ExecuteCommand2");
        assertThat(result.status()).isZero();
    }
}
