//! The commands that lead from some parameters to others.

use super::command::TectonicCommand;
use crate::params::{ProcessSwitches, TectonicParams};

impl TectonicCommand {
    /// The commands that change what differs between `old` and `new`, both valid, and nothing else.
    /// After each of them parameters are valid, too.
    ///
    /// ```
    /// # use bevy_pangaea::prelude::*;
    /// let old = TectonicParams::default();
    /// let new = TectonicParams { erosion: 0.03, ..old.clone() };
    /// assert_eq!(
    ///     TectonicCommand::between(&old, &new),
    ///     [TectonicCommand::SetParam { name: "erosion".into(), value: 0.03 }]
    /// );
    /// ```
    pub fn between(old: &TectonicParams, new: &TectonicParams) -> Vec<Self> {
        let rises = TectonicParams::TABLE
            .iter()
            .filter(|info| (info.get)(new) > (info.get)(old));
        let falls = TectonicParams::TABLE
            .iter()
            .rev()
            .filter(|info| (info.get)(new) < (info.get)(old));
        // Ridges come before abysses and trenches in the table, and must stay above them: what
        // rises does so from the top, what falls from the bottom.
        let params = rises.chain(falls).map(|info| Self::SetParam {
            name: info.name.into(),
            value: (info.get)(new),
        });
        let switches = ProcessSwitches::NAMES.into_iter().filter_map(|name| {
            let on = is_on(new, name);
            (on != is_on(old, name)).then(|| Self::SetProcess {
                name: name.into(),
                on,
            })
        });
        let law = new.ocean_floor;
        let floor = (law != old.ocean_floor).then_some(Self::SetOceanFloor { law });
        params.chain(switches).chain(floor).collect()
    }
}

fn is_on(params: &TectonicParams, name: &str) -> bool {
    let mut processes = params.processes;
    processes.get_mut(name).is_ok_and(|on| *on)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::OceanFloor;

    /// Carries commands out on parameters, as a planet does.
    fn follow(mut params: TectonicParams, commands: Vec<TectonicCommand>) -> TectonicParams {
        for command in commands {
            match command {
                TectonicCommand::SetParam { name, value } => params.set(&name, value).unwrap(),
                TectonicCommand::SetProcess { name, on } => {
                    *params.processes.get_mut(&name).unwrap() = on;
                }
                TectonicCommand::SetOceanFloor { law } => params.ocean_floor = law,
                other => panic!("{other:?} changes no parameter"),
            }
            params.validate().unwrap();
        }
        params
    }

    #[test]
    fn equal_parameters_need_no_command() {
        let params = TectonicParams::default();
        assert_eq!(TectonicCommand::between(&params, &params), []);
    }

    /// Parameters with elevations of trench, abyss and ridge in km.
    fn of_depths([trench, abyss, ridge]: [f64; 3]) -> TectonicParams {
        TectonicParams {
            trench_elevation: trench,
            abyss_elevation: abyss,
            ridge_elevation: ridge,
            ..TectonicParams::default()
        }
    }

    #[test]
    fn every_command_leaves_parameters_valid() {
        let deep = of_depths([-14.0, -9.0, -6.0]);
        let shallow = of_depths([-6.0, -4.0, -3.0]);
        let flat = of_depths([-6.0, -6.0, -6.0]);
        for old in [&deep, &shallow, &flat] {
            for new in [&deep, &shallow, &flat] {
                let commands = TectonicCommand::between(old, new);
                assert_eq!(&follow(old.clone(), commands), new);
            }
        }
    }

    #[test]
    fn switches_and_the_law_of_the_ocean_floor_follow() {
        let old = TectonicParams::default();
        let mut new = old.clone();
        new.processes.rifting = false;
        new.ocean_floor = OceanFloor::Paper;
        let commands = TectonicCommand::between(&old, &new);
        assert_eq!(commands.len(), 2);
        assert_eq!(follow(old, commands), new);
    }
}
