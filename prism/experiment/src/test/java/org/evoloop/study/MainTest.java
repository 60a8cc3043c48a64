package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

class MainTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String input, String... arguments) {
        BufferedReader stdin = new BufferedReader(new StringReader(input));
        return new CommandLine(new Main(stdin, print(out), print(err))).execute(arguments);
    }

    private static PrintStream print(ByteArrayOutputStream to) {
        return new PrintStream(to, true, StandardCharsets.UTF_8);
    }

    @Test
    void printsWhatItMeasuresForEachPoint() {
        int status = run("u,unbuffered,1,1,0.5,0.25,1,0,3,\np,pipelined,4,1,0.5,0.25,1,0,4,\n", "--runs", "20");

        assertThat(status).isZero();
        assertThat(err.toString(StandardCharsets.UTF_8)).isEmpty();
        assertThat(out.toString(StandardCharsets.UTF_8))
                .startsWith("point,quantity,t,n,mean,deviation\n")
                .containsPattern("u,lost,100,20,1[0-9]\\.")
                .containsPattern("u,lost_per_s,0,100,0\\.17")
                .containsPattern("u,wait_s,0,100,0\\.2[45]")
                .containsPattern("u,divergence_s,0,21,")
                .containsPattern("p,completion_s,0,20,[34][0-9]\\.")
                .doesNotContain("p,divergence_s");
    }

    @Test
    void measuresTheSameInThreads() {
        String point = "p,pipelined,2,1,0.5,0.25,1,0,4,\n";
        assertThat(run(point, "--runs", "5", "--batch", "100")).isZero();
        String steps = out.toString(StandardCharsets.UTF_8);
        out.reset();

        assertThat(run(point, "--runs", "5", "--batch", "100", "--threads")).isZero();
        assertThat(out.toString(StandardCharsets.UTF_8)).isEqualTo(steps);
    }

    @Test
    void measuresWhatDisturbsTheConverter() {
        String points = "c,pipelined,4,1,0.5,0.25,1,0,5,crash=20 recovery=5\n"
                + "p,pipelined,4,1,0.5,0,1,0,6,phases=2 first=0.4 more=0.5 last=0.4\n";
        assertThat(run(points, "--runs", "20", "--batch", "100")).isZero();

        assertThat(out.toString(StandardCharsets.UTF_8))
                .containsPattern("c,handed,100,20,3[0-9]\\.")
                .containsPattern("c,differs,0,100,0\\.[456]")
                .containsPattern("p,completion_s,0,20,[34][0-9]\\.")
                .containsPattern("p,differs,0,100,0\\.0+,");
    }

    @Test
    void disturbsNoThreads() {
        assertThat(run("c,pipelined,4,1,0.5,0.25,1,0,5,crash=20 recovery=5", "--threads"))
                .isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8)).endsWith("': without --threads only\n");
    }

    @Test
    void refusesAPointThatDoesNotFit() {
        for (String wrong : new String[] {
            "few,cells",
            "n,fast,1,1,0.5,0.25,1,0,1,",
            "n,serial,0,1,0.5,0.25,1,0,1,",
            "n,serial,1,1,0.5,0.25,1,0,1,crash=20 recovery=5",
            "n,pipelined,1,1,0.5,0.25,1,0,1,crush=20",
            "n,pipelined,1,1,0.5,0,1,0,1,phases=0 first=1"
        }) {
            err.reset();
            assertThat(run(wrong)).isEqualTo(2);
            assertThat(err.toString(StandardCharsets.UTF_8)).startsWith("error: '" + wrong + "'");
        }
    }
}
